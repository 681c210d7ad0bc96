#include "geometry/occ/faces/fault_reasons.h"

#include <gtest/gtest.h>

#include <BRep_Builder.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>

#include "tests/geometry/occ/meshing.h"

namespace af2::geometry {
namespace {

/// A box whose face of this number is turned inside out.
Model boxWithTurned(int turned) {
  TopoDS_Shell shell;
  BRep_Builder builder;
  builder.MakeShell(shell);
  const Model box = testing::box(1, 1, 1);
  for (int id = 1; id <= 6; ++id) {
    const TopoDS_Face face = box.shape().face(id);
    builder.Add(shell, id == turned ? TopoDS::Face(face.Reversed()) : face);
  }
  return testing::modelOf(shell);
}

std::vector<FaceReport> sixFailed() {
  std::vector<FaceReport> faces(6);
  for (int i = 0; i < 6; ++i) {
    faces[static_cast<std::size_t>(i)].id = i + 1;
    faces[static_cast<std::size_t>(i)].status = FaceStatus::Failed;
    faces[static_cast<std::size_t>(i)].reason = "stuck";
  }
  return faces;
}

TEST(TurnedEdges, AreToldOfAtFacesThatFailed) {
  std::vector<FaceReport> faces = sixFailed();
  tellOfTurnedEdges(boxWithTurned(2).shape(), faces);
  EXPECT_EQ(faces[0].reason, "stuck");  // opposite: no edge in common
  EXPECT_EQ(faces[0].cause, FailureCause::Unknown);
  EXPECT_NE(faces[1].reason.find("stuck; in the model itself it runs along edge "),
            std::string::npos)
      << faces[1].reason;
  EXPECT_EQ(faces[1].cause, FailureCause::Model);
  for (std::size_t i = 2; i < 6; ++i)
    EXPECT_NE(faces[i].reason.find("in the same direction as face 2:"), std::string::npos)
        << faces[i].reason;
}

TEST(TurnedEdges, AreNoneInASoundModel) {
  std::vector<FaceReport> faces = sixFailed();
  tellOfTurnedEdges(testing::box(1, 1, 1).shape(), faces);
  for (const FaceReport& face : faces) EXPECT_EQ(face.reason, "stuck");
  std::vector<FaceReport> mantle{faces[0]};  // with a seam
  tellOfTurnedEdges(testing::cylinder(1, 2).shape(), mantle);
  EXPECT_EQ(mantle[0].reason, "stuck");
}

/// The boundary of the first face lacks an edge, and the others run the wrong way.
TEST(TurnedEdges, AreToldOfInARun) {
  const Model box = testing::box(1, 1, 1);
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const auto& uses = box.shape().edgesOfFaces[0];
  for (std::size_t i = 0; i < 3; ++i) builder.Add(wire, uses[i].edge);
  TopoDS_Face open = TopoDS::Face(box.shape().face(1).EmptyCopied());
  builder.Add(open, wire);
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, open);
  for (int id = 2; id <= 6; ++id) builder.Add(shell, box.shape().face(id));
  const FaceReport face = testing::mesh(testing::modelOf(shell), 0.4).faces.at(0);
  EXPECT_EQ(face.status, FaceStatus::Failed);
  EXPECT_NE(face.reason.find("; in the model itself it runs along edge "), std::string::npos)
      << face.reason;
}

}  // namespace
}  // namespace af2::geometry
