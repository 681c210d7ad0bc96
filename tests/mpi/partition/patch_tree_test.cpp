#include "geometry/mpi/partition/patch_tree.h"

#include <gtest/gtest.h>

#include <map>

namespace af2::mpi {
namespace {

TEST(PatchTree, MakesPatchesOfNeighboursThatAreNotTooLarge) {
  std::vector<Point3> points;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 10; ++j) points.push_back({1.0 * i, 1.0 * j, 5});
  const PatchTree tree(points, 25);
  std::map<std::uint32_t, std::vector<Point3>> patches;
  for (const Point3& p : points) patches[tree.of(p)].push_back(p);
  EXPECT_EQ(patches.size(), tree.count());
  EXPECT_EQ(tree.count(), 16u);
  for (const auto& [patch, members] : patches) {
    EXPECT_LT(patch, tree.count());
    ASSERT_EQ(members.size(), 25u);
    for (const Point3& p : members) EXPECT_LE(distance(p, members.front()), 8) << "far away";
  }
  EXPECT_EQ(tree.of(points.front()), 0u) << "the patch of the first point is the first";
}

TEST(PatchTree, TellsPointsApartThatAgreeInMostCoordinates) {
  std::vector<Point3> points(50, Point3{1, 1, 1});
  points.push_back({1, 1, 2});
  points.push_back({1, 0, 2});
  const PatchTree tree(points, 1);
  EXPECT_EQ(tree.count(), 3u) << "only points at one place stay together";
  EXPECT_NE(tree.of(points[50]), tree.of(points[51]));
  EXPECT_NE(tree.of(points[50]), tree.of(points[0]));
}

}  // namespace
}  // namespace af2::mpi
