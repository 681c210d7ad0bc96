// Joining triangles where charts show little, or surfaces have no useful normals.
#include "engine/optimize/triangle_walk.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/mesh/mesh_check.h"
#include "engine/optimize/optimize.h"
#include "tests/support/limited_charts.h"
#include "tests/support/quad_grid.h"

namespace af2 {
namespace {

using namespace af2::testing;

TEST(TriangleWalk, TakesFewerElementsWhereChartsHideSome) {
  QuadGrid grid(8);
  grid.split(4, 4);
  const LimitedMaker shortSighted(
      {.shows = [](Point3, Point3, Point2 place) { return length(place) <= 2.5; }, .finds = {}});
  EXPECT_EQ(joinTriangles(grid.mesh, boundaryOf(grid.input), shortSighted), 1u);
  EXPECT_TRUE(std::ranges::all_of(grid.mesh.elements, &Element::isQuad));
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
}

/// As beside a sharp bend, across which only the charts of some sides look.
TEST(TriangleWalk, TriesTheChartsOfAllSides) {
  for (const bool isAlongX : {false, true}) {
    QuadGrid grid(6);
    grid.split(2, 2);
    const LimitedMaker oneWay(
        {.shows = [&](Point3 from, Point3 to,
                      Point2) { return (std::abs(to.x - from.x) > 0.5) == isAlongX; },
         .finds = {}});
    EXPECT_EQ(joinTriangles(grid.mesh, boundaryOf(grid.input), oneWay), 1u);
    EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
  }
}

TEST(TriangleWalk, LeavesVerticesThatAreNotFoundElsewhere) {
  QuadGrid grid(6);
  grid.split(2, 2);
  Point3& moved = grid.mesh.vertices[grid.id(3, 3).value].position;
  moved = {3.2, 3.2, 0};  // smoothing would move it back
  const LimitedMaker maker({.shows = {}, .finds = [](const Point3& p) {
                              return distance(p, Point3{3, 3, 0}) > 0.5;
                            }});
  EXPECT_EQ(joinTriangles(grid.mesh, boundaryOf(grid.input), maker), 1u);
  EXPECT_EQ(moved, (Point3{3.2, 3.2, 0}));
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
}

/// As where a surface bends sharply within an element: a quadrilateral is no worse than the
/// triangles that it replaces.
TEST(TriangleWalk, JoinsTrianglesThatLean) {
  QuadGrid grid(6);
  grid.split(0, 0);
  for (const VertexId v : {grid.id(0, 0), grid.id(1, 0), grid.id(0, 1)})
    grid.mesh.vertices[v.value].normal = {0.99, 0, 0.14};
  EXPECT_EQ(joinTriangles(grid.mesh, boundaryOf(grid.input), FlatMaker()), 1u);
  EXPECT_TRUE(std::ranges::all_of(grid.mesh.elements, &Element::isQuad));
}

}  // namespace
}  // namespace af2
