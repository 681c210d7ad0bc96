// How faces meet along edges.
#include "geometry/occ/merge/edge_joints.h"

#include <gtest/gtest.h>
#include <BRepFilletAPI_MakeFillet.hxx>

#include <algorithm>
#include <numbers>

#include "tests/geometry/occ/shapes.h"

namespace af2::geometry {
namespace {

TEST(EdgeJoints, KnowTheAnglesOfABox) {
  for (const EdgeJoint& joint : jointsOf(testing::box(1, 2, 3).shape(), 1)) {
    EXPECT_TRUE(joint.isJoint());
    EXPECT_NEAR(joint.angle, std::numbers::pi / 2, 1e-12);
    EXPECT_EQ(joint.bend, 0);
  }
}

TEST(EdgeJoints, KnowSeams) {
  const auto joints = jointsOf(testing::cylinder(2, 5).shape(), 1);
  const auto seam = std::ranges::find_if(
      joints, [](const EdgeJoint& joint) { return joint.isJoint() && joint.isSeam(); });
  ASSERT_NE(seam, joints.end());
  EXPECT_NEAR(seam->angle, 0, 1e-12);
  EXPECT_NEAR(seam->bend, 0, 1e-12);
}

TEST(EdgeJoints, KnowWhereRoundingsBegin) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 5, 6).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  fillet.Add(0.5, TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current()));
  const auto joints = jointsOf(testing::modelOf(fillet.Shape()).shape(), 1);
  EXPECT_EQ(std::ranges::count_if(joints,
                                  [](const EdgeJoint& joint) {
                                    return joint.angle < 1e-6 && std::abs(joint.bend - 2) < 1e-6;
                                  }),
            2);
}

TEST(EdgeJoints, LeaveOutFreeEdgesAndPoles) {
  const TopoDS_Face face = testing::plane({testing::rectangle(0, 0, 1, 1)});
  for (const EdgeJoint& joint : jointsOf(testing::modelOf(face).shape(), 1))
    EXPECT_FALSE(joint.isJoint());
  const auto ball = jointsOf(testing::sphere(1).shape(), 1);
  EXPECT_EQ(std::ranges::count_if(ball, [](const EdgeJoint& joint) { return joint.isJoint(); }), 1);
}

}  // namespace
}  // namespace af2::geometry
