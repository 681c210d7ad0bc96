#include "geometry/occ/inspect/edge_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/geometry/occ/shapes.h"

namespace af2::geometry {
namespace {

TEST(EdgeList, HasCurvesLengthsEndsAndFaces) {
  const std::vector<EdgeEntry> edges = edgesOf(testing::cylinder(2, 5));
  ASSERT_EQ(edges.size(), 3u);
  for (const EdgeEntry& edge : edges) {
    const bool isSeam = edge.curve == "line";
    EXPECT_NEAR(edge.length, isSeam ? 5 : 4 * std::numbers::pi, 1e-9);
    EXPECT_EQ(edge.faces.size(), isSeam ? 1u : 2u);
    EXPECT_EQ(distance(edge.from, edge.to), isSeam ? 5 : 0);
  }
  EXPECT_EQ(std::ranges::count(edges, "circle", &EdgeEntry::curve), 2);
}

TEST(EdgeList, LeavesOutPolesButKeepsTheIds) {
  const Model cone = testing::cone(1, 0, 3);
  const std::vector<EdgeEntry> edges = edgesOf(cone);
  EXPECT_EQ(edges.size(), 2u);
  EXPECT_EQ(cone.edgeCount(), 3);
  EXPECT_TRUE(std::ranges::is_sorted(edges, {}, &EdgeEntry::id));
}

}  // namespace
}  // namespace af2::geometry
