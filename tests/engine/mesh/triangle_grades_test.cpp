#include "engine/mesh/triangle_grades.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/quad_grid.h"

namespace af2 {
namespace {

/// A triangle with its third corner at some height above its side, which is 1 long.
struct Triangle {
  Mesh mesh;
  explicit Triangle(double height) {
    const auto at = [](double x, double y) { return SurfacePoint{{x, y, 0}, {0, 0, 1}, x, y}; };
    mesh.vertices = {at(0, 0), at(1, 0), at(0.5, height)};
    mesh.elements = {{{VertexId(0), VertexId(1), VertexId(2), {}}}};
    mesh.origins.resize(1);
  }
  TriangleGrade grade() {
    MeshTopology topology(mesh, {3, {}});
    return gradeOf(topology, 0);
  }
};

TEST(TriangleGrades, TellGoodAndEvenTriangles) {
  const double even = std::sqrt(0.75);
  EXPECT_EQ(Triangle(even).grade(), TriangleGrade::Even);
  EXPECT_EQ(Triangle(1.03 * even).grade(), TriangleGrade::Even);
  EXPECT_EQ(Triangle(1.1 * even).grade(), TriangleGrade::Good);
  EXPECT_EQ(Triangle(2 * even).grade(), TriangleGrade::Other);
  EXPECT_EQ(Triangle(-even).grade(), TriangleGrade::Other);  // faces down
}

TEST(TriangleGrades, AreFoundOnceUntilTheElementChanges) {
  Triangle triangle(std::sqrt(0.75));
  MeshTopology topology(triangle.mesh, {2, {}});
  EXPECT_TRUE(isGood(topology, 0));
  triangle.mesh.vertices[2].position.y = 3;
  EXPECT_TRUE(isGood(topology, 0));
  topology.move(VertexId(2), triangle.mesh.vertices[2]);
  EXPECT_FALSE(isGood(topology, 0));
}

TEST(TriangleGrades, KnowNothingOfQuadrilaterals) {
  testing::QuadGrid grid(1);
  MeshTopology topology(grid.mesh, boundaryOf(grid.input));
  EXPECT_EQ(gradeOf(topology, 0), TriangleGrade::Other);
}

}  // namespace
}  // namespace af2
