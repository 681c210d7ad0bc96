// That quadrilaterals which do not turn left at each corner are given a better shape.
#include "engine/optimize/turn_round.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/mesh/element_shape.h"
#include "engine/mesh/mesh_check.h"
#include "tests/support/flat_surface.h"
#include "tests/support/meshing.h"

namespace af2 {
namespace {

using namespace af2::testing;

struct Grid {
  FrontInput input;
  Mesh mesh;

  /// Of n by n unit squares; inner vertices come behind those of the boundary.
  explicit Grid(int n) : n_(n), at_(static_cast<std::size_t>((n + 1) * (n + 1))) {
    std::vector<Point2> outline;
    for (int i = 0; i < n; ++i) put(i, 0, outline);
    for (int i = 0; i < n; ++i) put(n, i, outline);
    for (int i = n; i > 0; --i) put(i, n, outline);
    for (int i = n; i > 0; --i) put(0, i, outline);
    addLoop(input, outline);
    for (const BoundaryCorner& c : input.loops[0]) mesh.vertices.push_back(c.point);
    for (int j = 1; j < n; ++j)
      for (int i = 1; i < n; ++i) {
        SurfacePoint point = mesh.vertices[0];
        point.position = {static_cast<double>(i), static_cast<double>(j), 0};
        at(i, j) = VertexId(mesh.vertices.size());
        mesh.vertices.push_back(point);
      }
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) add({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }

  VertexId& at(int i, int j) { return at_[static_cast<std::size_t>(j * (n_ + 1) + i)]; }
  void add(const std::array<VertexId, 4>& corners) {
    Element element;
    element.corners = corners;
    mesh.elements.push_back(element);
    mesh.origins.emplace_back();
  }
  std::size_t turnRound() { return turnElementsRound(mesh, boundaryOf(input), FlatMaker(), {}); }

 private:
  void put(int i, int j, std::vector<Point2>& outline) {
    at(i, j) = VertexId(outline.size());
    outline.push_back({static_cast<double>(i), static_cast<double>(j)});
  }
  int n_;
  std::vector<VertexId> at_;
};

TEST(TurnRound, MovesAVertexThatFoldsTheElementsAroundIt) {
  Grid grid(4);
  grid.mesh.vertices[grid.at(2, 2).value].position = {3.2, 3.4, 0};
  ASSERT_TRUE(hasTurnedElements(grid.mesh));
  EXPECT_EQ(grid.turnRound(), 0u);
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
}

// The boundary has a tip of one degree: nothing can mend the element there.
TEST(TurnRound, MendsElementsBesideOneThatCannotBeMended) {
  Grid grid(4);
  grid.mesh.vertices[grid.at(0, 1).value].position = {0.98, 0.02, 0};
  for (BoundaryCorner& c : grid.input.loops[0]) c.point = grid.mesh.vertices[c.vertex.value];
  grid.mesh.vertices[grid.at(1, 1).value].position = {2.3, 2.4, 0};
  EXPECT_LE(grid.turnRound(), 1u);
  const auto turned = std::ranges::count_if(
      grid.mesh.elements, [&](const Element& element) { return leans(grid.mesh, element); });
  EXPECT_LE(turned, 1);
}

// Where the boundary is straight at a corner, no vertex can move to mend the element.
TEST(TurnRound, DividesAnElementWithAStraightCornerOnTheBoundary) {
  FrontInput input;
  addLoop(input, {{0, 0}, {1, 0}, {2, 0}, {1, 1.7}});
  Mesh mesh;
  for (const BoundaryCorner& c : input.loops[0]) mesh.vertices.push_back(c.point);
  Element element;
  element.corners = {VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  mesh.elements.push_back(element);
  mesh.origins.emplace_back();
  ASSERT_TRUE(hasTurnedElements(mesh));
  EXPECT_EQ(turnElementsRound(mesh, boundaryOf(input), FlatMaker(), {}), 0u);
  EXPECT_TRUE(checkMesh(mesh, input).empty());
  EXPECT_EQ(mesh.elements.size(), 5u);
}

}  // namespace
}  // namespace af2
