#include "geometry/fill/drawn_front.h"

#include <gtest/gtest.h>

#include <vector>

namespace af2::geometry {
namespace {

/// A square of length 1 with a tail along x, and an edge from each vertex to the next.
DrawnFront squareWithTail() {
  DrawnFront front({{VertexId(0), {0, 0}},
                    {VertexId(1), {1, 0}},
                    {VertexId(2), {5, 0.1}},
                    {VertexId(3), {1, 1}},
                    {VertexId(4), {0, 1}}});
  for (std::uint32_t v = 0; v < 5; ++v) front.add({VertexId(v), VertexId((v + 1) % 5)});
  return front;
}

std::vector<std::size_t> edgesFrom(const DrawnFront& front, Point2 place, double reach) {
  std::vector<std::size_t> edges;
  front.forEachFrom(front.stretchAt(place, reach), [&](std::size_t i) {
    edges.push_back(i);
    return true;
  });
  std::ranges::sort(edges);
  return edges;
}

TEST(DrawnFront, FindsEdgesAlongIt) {
  const DrawnFront front = squareWithTail();
  EXPECT_EQ(edgesFrom(front, {0, 7}, 0.5), (std::vector<std::size_t>{0, 4}));
  EXPECT_EQ(edgesFrom(front, {0, 7}, 1), (std::vector<std::size_t>{0, 1, 3, 4}));
  EXPECT_FALSE(front.isAll(front.stretchAt({0, 0}, 4)));
  EXPECT_TRUE(front.isAll(front.stretchAt({0, 0}, 5)));
  EXPECT_DOUBLE_EQ(front.farthestAcross({2, 0.25}), 0.75);
}

TEST(DrawnFront, FindsEdgesThatReachToATriangle) {
  const DrawnFront front = squareWithTail();
  std::vector<std::size_t> near;
  front.forEachNear({3, 0}, {3.2, 0}, {3, 0.3}, [&](std::size_t i) {
    near.push_back(i);
    return true;
  });
  std::ranges::sort(near);
  EXPECT_EQ(near, (std::vector<std::size_t>{1, 2})) << "both start elsewhere";
}

TEST(DrawnFront, ForgetsEdgesThatAreTakenOut) {
  DrawnFront front = squareWithTail();
  EXPECT_EQ(front.shortest(), 0u);
  EXPECT_TRUE(front.takeOut({VertexId(0), VertexId(1)}));
  EXPECT_FALSE(front.takeOut({VertexId(0), VertexId(1)}));
  EXPECT_FALSE(front.has({VertexId(0), VertexId(1)}));
  EXPECT_EQ(front.shortest(), 3u);
  EXPECT_EQ(edgesFrom(front, {0, 0}, 0.5), std::vector<std::size_t>{4});
  front.add({VertexId(0), VertexId(3)});
  EXPECT_EQ(edgesFrom(front, {0, 0}, 0.5), (std::vector<std::size_t>{4, 5}));
}

}  // namespace
}  // namespace af2::geometry
