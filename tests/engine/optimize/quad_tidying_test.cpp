// That what fronts of quadrilaterals leave is tidied up, and nothing else is touched.
#include "engine/optimize/quad_tidying.h"

#include <gtest/gtest.h>

#include "engine/mesh/mesh_check.h"
#include "engine/optimize/optimize.h"
#include "tests/support/meshing.h"
#include "tests/support/quad_grid.h"

namespace af2 {
namespace {

using namespace af2::testing;

std::size_t tidied(QuadGrid& grid, std::optional<std::uint16_t> closingRule = {},
                   const WorkWatch& watch = {}) {
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
  MeshTopology topology(grid.mesh, boundaryOf(grid.input));
  const std::size_t changes = tidyQuads(topology, topology.anglesAtFixed(), closingRule, nullptr,
                                        MayAddTriangles::Yes, watch);
  topology.compact();
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
  EXPECT_NEAR(areaOf(grid.mesh), grid.n * grid.n, 1e-12);
  return changes;
}

void expectQuadsOnly(const Mesh& mesh, std::size_t quads, std::size_t vertices) {
  EXPECT_EQ(mesh.elements.size(), quads);
  EXPECT_TRUE(std::ranges::all_of(mesh.elements, &Element::isQuad));
  EXPECT_EQ(mesh.vertices.size(), vertices);
}

TEST(QuadTidying, LeavesARegularGridAsItIs) {
  QuadGrid grid(4);
  const Mesh before = grid.mesh;
  EXPECT_EQ(tidied(grid), 0u);
  EXPECT_EQ(grid.mesh, before);
}

TEST(QuadTidying, PutsTwoTrianglesTogether) {
  QuadGrid grid(3);
  grid.split(1, 1);
  EXPECT_EQ(tidied(grid), 1u);
  expectQuadsOnly(grid.mesh, 9, 16);
}

TEST(QuadTidying, TakesTwoTrianglesAndWhatIsBetweenThem) {
  QuadGrid grid(4);
  grid.element(1, 1) = {{grid.id(1, 1), grid.id(2, 1), grid.id(1, 2), {}}};
  grid.element(2, 1) = {{grid.id(2, 1), grid.id(3, 1), grid.id(2, 2), grid.id(1, 2)}};
  grid.addElement({{grid.id(3, 1), grid.id(3, 2), grid.id(2, 2), {}}});
  EXPECT_GE(tidied(grid), 1u);
  expectQuadsOnly(grid.mesh, 16, 25);
}

/// A row whose elements lean from a triangle at its left end to one at its right.
QuadGrid gridWithLeaningRow(int n, int row, int from, int to) {
  QuadGrid grid(n);
  const auto low = [&](int i) { return grid.id(i, row); };
  const auto high = [&](int i) { return grid.id(i, row + 1); };
  grid.element(from, row) = {{low(from), low(from + 1), high(from), {}}};
  for (int i = from + 1; i < to; ++i)
    grid.element(i, row) = {{low(i), low(i + 1), high(i), high(i - 1)}};
  grid.addElement({{low(to), high(to), high(to - 1), {}}});
  return grid;
}

TEST(QuadTidying, PairsTrianglesThatAreFarApart) {
  QuadGrid grid = gridWithLeaningRow(12, 5, 2, 9);
  EXPECT_GE(tidied(grid), 1u);
  expectQuadsOnly(grid.mesh, 144, 169);
}

TEST(QuadTidying, StopsOnRequest) {
  QuadGrid grid = gridWithLeaningRow(12, 5, 2, 9);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(tidied(grid, {}, stop.get_token()), 0u);
}

TEST(QuadTidying, MakesQuadrilateralsOfTrianglesThatClosedAFront) {
  constexpr std::uint16_t kClosing = 7;
  QuadGrid grid(8);
  for (int i = 0; i < 8; ++i) {
    grid.split(i, 3);
  }
  for (std::size_t e = 0; e < grid.mesh.elements.size(); ++e)
    if (!grid.mesh.elements[e].isQuad()) grid.mesh.origins[e].rule = kClosing;
  QuadGrid meant = grid;
  EXPECT_EQ(tidied(meant), 0u);
  EXPECT_EQ(tidied(grid, kClosing), 8u);
  expectQuadsOnly(grid.mesh, 64, 81);
}

TEST(QuadTidying, TakesOutAFlatQuadrilateral) {
  QuadGrid grid(4);
  const VertexId above = grid.addVertex({2, 2.2});
  const VertexId below = grid.id(2, 2), left = grid.id(1, 2), right = grid.id(3, 2);
  grid.mesh.vertices[below.value].position.y = 1.8;
  for (Element* element : {&grid.element(1, 2), &grid.element(2, 2)})
    std::ranges::replace(element->corners, below, above);
  grid.addElement({{left, below, right, above}});
  EXPECT_EQ(tidied(grid), 1u);
  expectQuadsOnly(grid.mesh, 16, 25);
}

TEST(QuadTidying, SplitsAQuadrilateralWithAStraightCornerAtTheRim) {
  FrontInput input;
  addLoop(input, {{0, 0}, {0.5, 0}, {1, 0}, {0.5, 0.8}});
  Mesh mesh;
  for (const BoundaryCorner& c : input.loops[0]) mesh.vertices.push_back(c.point);
  mesh.elements = {{{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}}};
  mesh.origins.resize(1);
  MeshTopology topology(mesh, boundaryOf(input));
  EXPECT_EQ(tidyQuads(topology, topology.anglesAtFixed(), {}), 1u);
  topology.compact();
  EXPECT_EQ(mesh.elements.size(), 2u);
  EXPECT_TRUE(checkMesh(mesh, input).empty());
}

TEST(QuadTidying, LeavesManyTrianglesSideBySide) {
  QuadGrid grid(4);
  for (int j = 0; j < 4; ++j)
    for (int i = 2; i < 4; ++i) {
      grid.split(i, j);
    }
  EXPECT_EQ(tidied(grid), 0u);
}

TEST(QuadTidying, IsPartOfOptimising) {
  QuadGrid grid(3);
  grid.split(1, 1);
  EXPECT_EQ(optimizeMesh(grid.mesh, boundaryOf(grid.input), FlatMaker()).replacements, 1u);
  expectQuadsOnly(grid.mesh, 9, 16);
}

}  // namespace
}  // namespace af2
