// That irregular vertices are removed, triangles are joined, and nothing else is touched.
#include "engine/optimize/quad_search.h"

#include <gtest/gtest.h>

#include "engine/mesh/mesh_check.h"
#include "engine/optimize/optimize.h"
#include "engine/optimize/triangle_walk.h"
#include "tests/support/meshing.h"
#include "tests/support/quad_grid.h"

namespace af2 {
namespace {

using namespace af2::testing;

/// What `work` did to the grid; the mesh must be sound before and after it.
template <class Work>
std::size_t changesOf(QuadGrid& grid, const Work& work) {
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
  MeshTopology topology(grid.mesh, boundaryOf(grid.input));
  const FlatMaker maker;
  PatchEditor editor(topology, maker, topology.anglesAtFixed());
  const std::size_t changes = work(editor);
  topology.compact();
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
  EXPECT_NEAR(areaOf(grid.mesh), grid.n * grid.n, 1e-9);
  return changes;
}

std::size_t searched(QuadGrid& grid, int depth) {
  return changesOf(grid, [&](PatchEditor& editor) { return searchQuads(editor, depth, {}); });
}

std::size_t walked(QuadGrid& grid) {
  return changesOf(grid, [](PatchEditor& editor) { return walkTriangles(editor, {}); });
}

std::size_t countTriangles(const Mesh& mesh) {
  return mesh.elements.size() -
         static_cast<std::size_t>(std::ranges::count_if(mesh.elements, &Element::isQuad));
}

/// Inner vertices with other than four quadrilaterals.
std::size_t countIrregular(const QuadGrid& grid) {
  std::vector<int> count(grid.mesh.vertices.size(), 0);
  for (const Element& element : grid.mesh.elements)
    for (const VertexId v : element.vertices()) ++count[v.value];
  const auto first = boundaryOf(grid.input).fixedCount;
  return static_cast<std::size_t>(std::count_if(count.begin() + static_cast<std::ptrdiff_t>(first),
                                                count.end(), [](int quads) { return quads != 4; }));
}

/// The side between the squares (i, j) and (i + 1, j), rotated: two vertices with three
/// quadrilaterals and two with five.
QuadGrid gridWithRotatedSide(int n, int i, int j) {
  QuadGrid grid(n);
  const VertexId a = grid.id(i, j), b = grid.id(i + 1, j), c = grid.id(i + 2, j),
                 d = grid.id(i + 2, j + 1), e = grid.id(i + 1, j + 1), f = grid.id(i, j + 1);
  grid.element(i, j) = {{a, b, c, d}};
  grid.element(i + 1, j) = {{d, e, f, a}};
  // Well shaped enough to be a mesh: the two ends of the side move apart.
  grid.mesh.vertices[b.value].position.y -= 0.4;
  grid.mesh.vertices[e.value].position.y += 0.4;
  return grid;
}

/// A row that ends inside: the vertex at its end has three quadrilaterals, another one five.
QuadGrid gridWithOpenedVertex(int n, int i, int j) {
  QuadGrid grid(n);
  const VertexId v = grid.id(i, j), split = grid.addVertex({i + 0.0, j + 0.3});
  grid.mesh.vertices[v.value].position.y -= 0.3;
  for (Element* element : {&grid.element(i - 1, j), &grid.element(i, j)})
    std::ranges::replace(element->corners, v, split);
  grid.addElement({{grid.id(i - 1, j), v, grid.id(i + 1, j), split}});
  return grid;
}

TEST(QuadSearch, LeavesARegularGridAsItIs) {
  QuadGrid grid(5);
  const Mesh before = grid.mesh;
  EXPECT_EQ(searched(grid, 3), 0u);
  EXPECT_EQ(grid.mesh, before);
}

TEST(QuadSearch, RotatesASideBack) {
  QuadGrid grid = gridWithRotatedSide(6, 2, 3);
  EXPECT_EQ(countIrregular(grid), 4u);
  EXPECT_EQ(searched(grid, 1), 1u);
  EXPECT_EQ(countIrregular(grid), 0u);
  EXPECT_EQ(grid.mesh.elements.size(), 36u);
}

TEST(QuadSearch, CollapsesAQuadrilateral) {
  QuadGrid grid = gridWithOpenedVertex(6, 3, 3);
  EXPECT_EQ(countIrregular(grid), 4u);
  EXPECT_EQ(searched(grid, 1), 1u);
  EXPECT_EQ(countIrregular(grid), 0u);
  EXPECT_EQ(grid.mesh.elements.size(), 36u);
  EXPECT_EQ(grid.mesh.vertices.size(), 49u);
}

/// Collapsing a quadrilateral leaves two vertices with three and one with six: only opening one
/// makes the grid again.
TEST(QuadSearch, OpensAVertex) {
  QuadGrid grid(6);
  const VertexId gone = grid.id(2, 2), into = grid.id(3, 3);
  auto& elements = grid.mesh.elements;
  elements.erase(elements.begin() + 2 + 6 * 2);
  grid.mesh.origins.pop_back();
  for (Element& element : elements) std::ranges::replace(element.corners, gone, into);
  grid.mesh.vertices[into.value].position = {2.5, 2.5, 0};
  // Without a gap among the vertices.
  const VertexId last(grid.mesh.vertices.size() - 1);
  for (Element& element : elements) std::ranges::replace(element.corners, last, gone);
  grid.mesh.vertices[gone.value] = grid.mesh.vertices.back();
  grid.mesh.vertices.pop_back();
  EXPECT_EQ(countIrregular(grid), 3u);
  EXPECT_GE(searched(grid, 1), 1u);
  EXPECT_EQ(countIrregular(grid), 0u);
  EXPECT_EQ(grid.mesh.vertices.size(), 49u);
}

/// Two steps are needed where each alone leaves as many irregular vertices as before.
TEST(QuadSearch, TakesTwoStepsWhereOneDoesNotHelp) {
  QuadGrid one = gridWithRotatedSide(9, 3, 4);
  const VertexId a = one.id(3, 4), d = one.id(5, 5);
  // Rotate the side once more, in the hexagon of the element above it.
  ASSERT_EQ(one.element(4, 4), (Element{{d, one.id(4, 5), one.id(3, 5), a}}));
  QuadGrid two = one;
  EXPECT_EQ(searched(one, 1), 1u);
  EXPECT_LE(countIrregular(one), countIrregular(two));
  EXPECT_GE(searched(two, 2), 1u);
  EXPECT_EQ(countIrregular(two), 0u);
}

/// Inner vertices with other than four quadrilaterals, at most `edges` edges from the boundary.
std::size_t countIrregularNearBoundary(const QuadGrid& grid, int edges) {
  QuadGrid copy = grid;
  std::size_t count = 0;
  changesOf(copy, [&](PatchEditor& editor) {
    for (std::size_t v = 0; v < copy.mesh.vertices.size(); ++v) {
      const Point3 p = copy.mesh.vertices[v].position;
      const double fromBoundary = std::min({p.x, p.y, copy.n - p.x, copy.n - p.y});
      const bool isNear = fromBoundary > 0 && fromBoundary < edges + 0.5;
      count += isNear && editor.irregularity(VertexId(v)) > 0 ? 1 : 0;
    }
    return std::size_t{0};
  });
  return count;
}

TEST(InwardSearch, MovesTheEndOfARowAwayFromTheBoundary) {
  QuadGrid grid = gridWithOpenedVertex(9, 4, 2);
  const std::size_t before = countIrregular(grid);
  EXPECT_GE(countIrregularNearBoundary(grid, 2), 3u);
  EXPECT_GE(changesOf(grid, [](PatchEditor& editor) { return moveInward(editor, 2, {}); }), 1u);
  EXPECT_EQ(countIrregularNearBoundary(grid, 2), 0u);
  EXPECT_LE(countIrregular(grid), before);
}

TEST(InwardSearch, LeavesWhatIsInsideAsItIs) {
  QuadGrid grid = gridWithOpenedVertex(10, 5, 5);
  const Mesh before = grid.mesh;
  EXPECT_EQ(changesOf(grid, [](PatchEditor& editor) { return moveInward(editor, 2, {}); }), 0u);
  EXPECT_EQ(grid.mesh, before);
}

TEST(QuadSearch, IsPartOfOptimisingUnlessTheDepthIsZero) {
  QuadGrid grid = gridWithRotatedSide(6, 2, 3);
  OptimizeOptions none;
  none.quads.depth = 0;
  QuadGrid same = grid;
  optimizeMesh(grid.mesh, boundaryOf(grid.input), FlatMaker());
  EXPECT_EQ(countIrregular(grid), 0u);
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
  optimizeMesh(same.mesh, boundaryOf(same.input), FlatMaker(), none);
  EXPECT_TRUE(checkMesh(same.mesh, same.input).empty());
}

/// A row whose elements lean from a triangle at its left end to one at its right.
void lean(QuadGrid& grid, int row, int from, int to) {
  const auto low = [&](int i) { return grid.id(i, row); };
  const auto high = [&](int i) { return grid.id(i, row + 1); };
  grid.element(from, row) = {{low(from), low(from + 1), high(from), {}}};
  for (int i = from + 1; i < to; ++i)
    grid.element(i, row) = {{low(i), low(i + 1), high(i), high(i - 1)}};
  grid.addElement({{low(to), high(to), high(to - 1), {}}});
}

TEST(TriangleWalk, JoinsTrianglesThatAreFarApart) {
  QuadGrid grid(30);
  lean(grid, 14, 2, 27);
  EXPECT_EQ(walked(grid), 1u);
  EXPECT_EQ(countTriangles(grid.mesh), 0u);
}

TEST(TriangleWalk, JoinsTheNearestFirst) {
  QuadGrid grid(30);
  lean(grid, 14, 2, 20);
  grid.split(10, 10);
  EXPECT_EQ(walked(grid), 2u);
  EXPECT_EQ(countTriangles(grid.mesh), 0u);
  EXPECT_EQ(countIrregular(grid), 0u);
}

TEST(TriangleWalk, JoinsTheTrianglesOfAMesh) {
  QuadGrid grid(8);
  grid.split(1, 1);
  EXPECT_EQ(joinTriangles(grid.mesh, boundaryOf(grid.input), FlatMaker()), 1u);
  EXPECT_EQ(countTriangles(grid.mesh), 0u);
  EXPECT_EQ(joinTriangles(grid.mesh, boundaryOf(grid.input), FlatMaker()), 0u);
}

}  // namespace
}  // namespace af2
