#include "geometry/occ/model/whole_surfaces.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <numbers>

#include "geometry/io/report.h"
#include "tests/geometry/occ/in_iges.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/shapes.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

constexpr double kWhole = 4 * std::numbers::pi * std::numbers::pi;  // area, by both radii

/// A torus of the radii 2 and 0.5 as a revolution: all corners of its boundary are the same point.
TopoDS_Shape turnedCircle() {
  const gp_Circ circle(gp_Ax2({2, 0, 0}, {0, 1, 0}), 0.5);
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(circle).Edge(), gp_Ax1({0, 0, 0}, gp::DZ()))
      .Shape();
}

Model readFromIges(const std::vector<TopoDS_Shape>& shapes) {
  const testing::TestFile file("turned.igs", testing::inIges(shapes));
  return readModel(file.path());
}

TEST(WholeSurfaces, OfIgesFilesThatLostTheirSeamsAreMeshed) {
  const Model model = readFromIges({turnedCircle()});
  EXPECT_EQ(model.notes().size(), 1u);
  const ModelMesh mesh = testing::mesh(model, 0.2);
  EXPECT_EQ(statusOf(mesh), RunStatus::Complete);
  EXPECT_NEAR(mesh.faces.at(0).area, kWhole, 1e-6 * kWhole);
}

TEST(WholeSurfaces, DoNotVanishWhenOtherFacesAreSewn) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(10, 0, 0), 1, 1, 1).Shape();
  EXPECT_EQ(readFromIges({box, turnedCircle()}).faceCount(), 7);
}

/// A face of a torus between edges along its lines of constant parameter.
TopoDS_Shape torusFace(double u2, double v2) {
  return BRepBuilderAPI_MakeFace(gp_Torus(gp_Ax3(), 2, 0.5), 0, u2, 0, v2).Shape();
}

TEST(WholeSurfaces, AreNotMadeOfFacesThatEncloseSomething) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (const double part : {0.25, 1.0}) {
    ReadShape read;
    read.shape = torusFace(kTurn, part * kTurn);
    giveWholeBoundaries(read);
    EXPECT_TRUE(read.notes.empty()) << part;
  }
}

/// The rim of a cap, whose pole and seam are lost.
TEST(WholeSurfaces, AreNotMadeOfFacesThatHaveOneCircleOnly) {
  const gp_Torus torus(gp_Ax3(), 2, 0.5);
  const gp_Circ rim(gp_Ax2(gp_Pnt(), gp::DZ()), 2.5);
  ReadShape read;
  read.shape =
      BRepBuilderAPI_MakeFace(torus, BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(rim))).Shape();
  giveWholeBoundaries(read);
  EXPECT_TRUE(read.notes.empty());
}

}  // namespace
}  // namespace af2::geometry
