#include "geometry/occ/read/crossed_faces.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepTools_ReShape.hxx>

#include <numbers>

#include "geometry/occ/model/turned_faces.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;
using testing::sphereOf;

TopoDS_Shape block(const gp_Pnt& low, const gp_Pnt& high) {
  return BRepPrimAPI_MakeBox(low, high).Shape();
}

/// A block with a quarter of a ball taken out at an edge, and a rod on an arm that reaches to where
/// the other three quarters would be.
TopoDS_Shape part() {
  const gp_Ax2 axis({0, 0, 0}, {0, 0, 1}, {-1, 0, 0});
  const TopoDS_Shape quarter = BRepPrimAPI_MakeSphere(axis, 1, pi / 2).Shape();
  const TopoDS_Shape hollow = BRepAlgoAPI_Cut(block({-3, -3, -3}, {0, 0, 3}), quarter).Shape();
  const TopoDS_Shape arm = block({-3, -3, -3}, {3, -2, 3}),
                     rod = block({0.4, -2, -0.1}, {0.6, -0.3, 0.1});
  const TopoDS_Shape all = BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(hollow, arm).Shape(), rod).Shape();
  return TopExp_Explorer(all, TopAbs_SOLID).Current();
}

const double kVolume = 54 - pi / 3 + 18 + 0.2 * 0.2 * 1.7;

ReadShape readAs(const TopoDS_Shape& shape) {
  ReadShape read;
  read.shape = shape;
  return read;
}

/// The same with the rest of the sphere.
TopoDS_Shape withRest(const TopoDS_Shape& shape) {
  const TopoDS_Face sphere = sphereOf(shape), rest = restOf(sphere);
  EXPECT_FALSE(rest.IsNull());
  BRepTools_ReShape replacing;
  replacing.Replace(sphere, rest);
  return replacing.Apply(shape);
}

TEST(CrossedFaces, BecomeTheRestThatNothingCrosses) {
  for (const bool isReversed : {false, true}) {
    const TopoDS_Shape wrong = withRest(part());
    const TopoDS_Shape shell = TopExp_Explorer(wrong, TopAbs_SHELL).Current();
    ReadShape read = readAs(isReversed ? shell.Reversed() : shell);
    turnBackCrossedFaces(read);
    ASSERT_EQ(read.notes.size(), 1u);
    EXPECT_NE(read.notes[0].find("1 faces between two poles"), std::string::npos);
    const ModelMesh result = testing::mesh(read.shape, 0.5);
    testing::expectComplete(result);
    EXPECT_NEAR(testing::volumeOf(result), kVolume, 0.1);
  }
}

TEST(CrossedFaces, AreNoneInAPartAsItShouldBe) {
  ReadShape read = readAs(part());
  turnBackCrossedFaces(read);
  EXPECT_TRUE(read.notes.empty());
}

/// Either of the two would do.
TEST(CrossedFaces, AreNoneIfNothingCrosses) {
  const TopoDS_Shape wedge =
      BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, {0, 0, 1}), 1, pi / 2).Shape();
  for (const TopoDS_Shape& shape : {wedge, withRest(wedge)}) {
    ReadShape read = readAs(shape);
    turnBackCrossedFaces(read);
    EXPECT_TRUE(read.notes.empty());
  }
}

}  // namespace
}  // namespace af2::geometry
