#include "geometry/occ/faces/crossed_edges.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeWire.hxx>
#include <algorithm>
#include <string>

#include "geometry/occ/inspect/defects.h"
#include "geometry/occ/run/cad_faces.h"
#include "tests/geometry/occ/curves.h"
#include "tests/geometry/occ/meshing.h"

namespace af2::geometry {
namespace {

/// Two triangles that meet where their sides cross, at (1, 1).
Model bowTie() {
  BRepBuilderAPI_MakePolygon polygon({0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, true);
  return testing::modelOf(testing::plane({polygon.Wire()}));
}

/// Bounded by one curve, which makes a loop, and a line.
Model loopedSheet() {
  const auto curve =
      testing::splineThrough({{0, 0, 0}, {4, 2, 0}, {3, 3, 0}, {2, 2, 0}, {4, 0, 0}, {5, 0, 0}});
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(curve).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(5, 0, 0), gp_Pnt(0, 0, 0)).Edge());
  return testing::modelOf(testing::plane({wire.Wire()}));
}

TEST(CrossedEdges, AreFoundWhereTwoCross) {
  const auto crossed = crossedEdges(bowTie().shape(), 1);
  ASSERT_TRUE(crossed);
  EXPECT_NE(crossed->one, crossed->other);
  EXPECT_NEAR(crossed->place.x, 1, 1e-9);
  EXPECT_NEAR(crossed->place.y, 1, 1e-9);
}

TEST(CrossedEdges, AreFoundWhereOneCrossesItself) {
  const auto crossed = crossedEdges(loopedSheet().shape(), 1);
  ASSERT_TRUE(crossed);
  EXPECT_EQ(crossed->one, crossed->other);
  EXPECT_TRUE(textOf(*crossed).starts_with("in the model itself edge 1 crosses itself at ("))
      << textOf(*crossed);
}

TEST(CrossedEdges, AreNoneInASoundModel) {
  const TopoDS_Wire hole = testing::rectangle(1, 1, 2, 2);
  const Model sheet = testing::modelOf(
      testing::plane({testing::rectangle(0, 0, 3, 3), TopoDS::Wire(hole.Reversed())}));
  EXPECT_FALSE(crossedEdges(sheet.shape(), 1));
  const Model cylinder = testing::cylinder(1, 2);
  for (int face = 1; face <= 3; ++face) EXPECT_FALSE(crossedEdges(cylinder.shape(), face));
}

TEST(CrossedEdges, AreToldOf) {
  for (const Model& model : {bowTie(), loopedSheet()}) {
    const FaceReport face = testing::mesh(model, 0.3).faces.at(0);
    EXPECT_EQ(face.status, FaceStatus::Failed);
    EXPECT_NE(face.reason.find("; in the model itself edge "), std::string::npos) << face.reason;
  }
}

/// So that the run does not try shorter edges.
TEST(CrossedEdges, AreAFaultInTheModel) {
  const Model crossed = loopedSheet(), sound = testing::box(1, 1, 1);
  for (const Model* model : {&crossed, &sound}) {
    CadFaces faces(*model, {});
    const MeshingOptions options = testing::ofSize(0.3);
    faces.prepare(options, {1});
    EXPECT_EQ(faces.hasFaultInModel(1), model == &crossed);
  }
}

TEST(CrossedEdges, AreDefects) {
  const auto defects = findDefects(loopedSheet(), 0.3);
  EXPECT_TRUE(std::ranges::any_of(
      defects, [](const Defect& defect) { return defect.detail == "edge 1 crosses itself"; }));
}

}  // namespace
}  // namespace af2::geometry
