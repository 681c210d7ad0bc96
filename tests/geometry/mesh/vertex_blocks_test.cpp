#include "geometry/mesh/vertex_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/planar_meshes.h"

namespace af2::geometry {
namespace {

/// Whether each element is visited, once and in order, with each block in which it has a vertex.
void expectAllAtTheirBlocks(const ModelMesh& mesh) {
  const VertexBlocks blocks(mesh.vertices.size(), mesh.elements, 2);
  std::size_t next = 0;
  for (std::size_t b = 0; b < blocks.count(); ++b) {
    const VertexRange block = blocks[b];
    EXPECT_EQ(block.begin, next);
    next = block.end;
    std::vector<std::size_t> visited;
    blocks.forEachElementAt(b, [&](std::size_t i) { visited.push_back(i); });
    EXPECT_TRUE(std::ranges::is_sorted(visited, std::less_equal()));
    std::vector<bool> isVisited(mesh.elements.size(), false);
    for (const std::size_t i : visited) isVisited[i] = true;
    std::size_t missing = 0;
    for (std::size_t i = 0; i < mesh.elements.size(); ++i)
      for (const VertexId v : mesh.elements[i].vertices())
        missing += block.contains(v.value) && !isVisited[i];
    EXPECT_EQ(missing, 0u);
  }
  EXPECT_EQ(next, mesh.vertices.size());
}

TEST(VertexBlocks, HaveTheElementsOfTheirVertices) {
  expectAllAtTheirBlocks(squareGrid(3));
  ModelMesh large = squareGrid(400);  // three blocks
  std::reverse(large.elements.begin(), large.elements.begin() + 1000);
  expectAllAtTheirBlocks(large);
}

TEST(VertexBlocks, LeaveFarElementsOut) {
  const ModelMesh mesh = squareGrid(400);
  const VertexBlocks blocks(mesh.vertices.size(), mesh.elements, 1);
  ASSERT_GT(blocks.count(), 2u);
  std::size_t visits = 0;
  for (std::size_t b = 0; b < blocks.count(); ++b)
    blocks.forEachElementAt(b, [&](std::size_t) { ++visits; });
  EXPECT_LT(visits, 2 * mesh.elements.size());
}

TEST(VertexBlocks, LeaveCornersOutThatAreNoVertices) {
  ModelMesh mesh = squareGrid(400);
  mesh.elements[7].corners[1] = VertexId(4'000'000'000u);
  expectAllAtTheirBlocks(mesh);
}

}  // namespace
}  // namespace af2::geometry
