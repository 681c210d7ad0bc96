#include "geometry/check/boundary_crossings.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/base/predicates.h"

namespace af2::geometry {
namespace {

FrontInput loopOf(const std::vector<Point2>& points) {
  FrontInput input;
  input.vertexCount = points.size();
  input.loops.emplace_back();
  for (std::size_t i = 0; i < points.size(); ++i)
    input.loops[0].push_back(
        {VertexId(i), {{points[i].x, points[i].y, 0}, {0, 0, 1}, points[i].x, points[i].y}});
  return input;
}

std::size_t crossings(const FrontInput& input, std::size_t limit = 100) {
  return crossingsOf(
             input,
             [](const SurfacePoint& p) {
               return Point2{p.u, p.v};
             },
             limit)
      .size();
}

TEST(BoundaryCrossings, NoneInASimplePolygon) {
  EXPECT_EQ(crossings(loopOf({{0, 0}, {2, 0}, {2, 1}, {1, 0.5}, {0, 1}})), 0u);
}

TEST(BoundaryCrossings, FindsTheOneOfABowTie) {
  const FrontInput input = loopOf({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  const auto found = crossingsOf(
      input,
      [](const SurfacePoint& p) {
        return Point2{p.u, p.v};
      },
      100);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first.corner + found[0].second.corner, 2u);  // segments 0 and 2
}

TEST(BoundaryCrossings, FindsAVertexOnAnotherSegment) {
  EXPECT_GT(crossings(loopOf({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}})), 0u);
}

TEST(BoundaryCrossings, FindsNeighboursThatRunBackOnEachOther) {
  // The second segment lies on the first, on which the third begins.
  EXPECT_EQ(crossings(loopOf({{0, 0}, {4, 0}, {2, 0}, {2, 2}})), 2u);
}

TEST(BoundaryCrossings, ALineInsideTheRegionIsNone) {
  FrontInput input = loopOf({{0, 0}, {3, 0}, {3, 3}, {0, 3}});
  input.vertexCount = 6;
  const BoundaryCorner a{VertexId(4), {{1, 1, 0}, {0, 0, 1}, 1, 1}};
  const BoundaryCorner b{VertexId(5), {{2, 2, 0}, {0, 0, 1}, 2, 2}};
  input.loops.push_back({a, b});
  EXPECT_EQ(crossings(input), 0u);
}

TEST(BoundaryCrossings, FindsEachPairOnceWhereverTheSegmentsAre) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<Point2> points;
  for (int i = 0; i < 60; ++i) points.push_back({any(random), any(random)});
  const std::size_t n = points.size();
  std::size_t meeting = 0;  // of segments without a common vertex; others do not overlap here
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 2; k < n - (i == 0 ? 1 : 0); ++k)
      if (segmentsMeet(points[i], points[(i + 1) % n], points[k], points[(k + 1) % n])) ++meeting;
  EXPECT_GT(meeting, 100u);
  EXPECT_EQ(crossings(loopOf(points), 10 * meeting), meeting);
}

TEST(BoundaryCrossings, StopsAtTheLimit) {
  std::vector<Point2> zigzag;
  for (int i = 0; i < 20; ++i) zigzag.push_back({i % 2 ? 10.0 : 0.0, 1.0 * i});
  zigzag.push_back({5, 30});
  zigzag.push_back({5, -10});
  EXPECT_GT(crossings(loopOf(zigzag)), 5u);
  EXPECT_EQ(crossings(loopOf(zigzag), 5), 5u);
}

}  // namespace
}  // namespace af2::geometry
