#include "geometry/mesh_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "small_meshes.h"

namespace af2::geometry {
namespace {

TEST(MeshEdges, HasEachEdgeOfACubeOnceAndSorted) {
  const std::vector<MeshEdge> edges = meshEdges(cubeMesh());
  EXPECT_EQ(edges.size(), 17u);
  for (const MeshEdge& edge : edges) {
    EXPECT_LT(edge.from, edge.to);
    EXPECT_EQ(edge.uses, 2);
  }
  for (std::size_t i = 1; i < edges.size(); ++i) {
    EXPECT_LT(std::pair(edges[i - 1].from, edges[i - 1].to), std::pair(edges[i].from, edges[i].to));
  }
}

TEST(MeshEdges, KnowsTheFacesOnBothSidesAndTheModelEdge) {
  const std::vector<MeshEdge> edges = meshEdges(cubeMesh());
  const MeshEdge expected{VertexId(4), VertexId(5), 2, 6, 1, 2};
  EXPECT_NE(std::ranges::find(edges, expected), edges.end());
}

TEST(MeshEdges, OfATriangleAreItsSides) {
  const std::vector<MeshEdge> edges = meshEdges(oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(edges, (std::vector<MeshEdge>{{VertexId(0), VertexId(1), 1, 1, 0, 1},
                                          {VertexId(0), VertexId(2), 1, 1, 0, 1},
                                          {VertexId(1), VertexId(2), 1, 1, 0, 1}}));
}

}  // namespace
}  // namespace af2::geometry
