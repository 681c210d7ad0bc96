// Two faces that have an edge inside in common.
#include "geometry/retry/shared_diagonals.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace af2::geometry {
namespace {

/// A corner at point 0 between points 1 and 2, closed by a triangle, and the element beyond it.
FaceMesh cornerFace(const Point3& inside, bool isTurned) {
  FaceMesh mesh;
  mesh.boundary = {0, 1, 2};
  mesh.inside = {inside};
  const VertexId tip(0), a(1), b(2), d(3);
  mesh.elements =
      isTurned ? std::vector{Element{{tip, b, a, VertexId()}}, Element{{a, b, d, VertexId()}}}
               : std::vector{Element{{tip, a, b, VertexId()}}, Element{{b, a, d, VertexId()}}};
  return mesh;
}

std::size_t elementsAt(const std::vector<FaceMesh>& meshes, std::uint32_t one,
                       std::uint32_t other) {
  std::size_t count = 0;
  for (const FaceMesh& mesh : meshes)
    for (const Element& element : mesh.elements) {
      std::set<std::uint32_t> points;
      for (const VertexId v : element.vertices())
        if (v.value < mesh.boundary.size()) points.insert(mesh.boundary[v.value]);
      if (points.contains(one) && points.contains(other)) ++count;
    }
  return count;
}

DividedEdges corner() {
  DividedEdges divided;
  divided.points = {{0, 0, 0}, {1, -0.4, 0}, {1, 0.4, 0}};
  return divided;
}

TEST(SharedDiagonals, AreSwappedInOneOfTheFaces) {
  std::vector<FaceMesh> meshes{cornerFace({1.8, 0, 0.1}, false), cornerFace({1.6, 0, -0.3}, true)};
  ASSERT_EQ(elementsAt(meshes, 1, 2), 4u);
  splitSharedDiagonals(corner(), meshes);
  EXPECT_EQ(elementsAt(meshes, 1, 2), 2u);
  EXPECT_EQ(elementsAt(meshes, 0, 1), 2u);  // segments of the boundary stay
  EXPECT_EQ(elementsAt(meshes, 0, 2), 2u);
  for (const FaceMesh& mesh : meshes) EXPECT_EQ(mesh.elements.size(), 2u);
}

TEST(SharedDiagonals, StayWhereTheOtherDiagonalWouldFold) {
  // Seen from the corner, the vertex beyond lies outside both sides.
  std::vector<FaceMesh> meshes{cornerFace({1.1, 3, 0.1}, false), cornerFace({1.1, 3, -0.1}, true)};
  splitSharedDiagonals(corner(), meshes);
  EXPECT_EQ(elementsAt(meshes, 1, 2), 4u);
}

/// Beside a narrow place between points 1 and 2 lie vertices inside, on both sides.
FaceMesh bridgeFace(double height) {
  FaceMesh mesh;
  mesh.boundary = {1, 2};
  mesh.inside = {{0.1, 0, height}, {1.9, 0, height}};
  const VertexId low(0), high(1), left(2), right(3);
  mesh.elements = {Element{{low, high, left, VertexId()}}, Element{{high, low, right, VertexId()}}};
  return mesh;
}

TEST(SharedDiagonals, OfDifferentTrianglesAreSwappedInOneOfTheFaces) {
  std::vector<FaceMesh> meshes{bridgeFace(0.2), bridgeFace(-0.1)};
  ASSERT_EQ(elementsAt(meshes, 1, 2), 4u);
  splitSharedDiagonals(corner(), meshes);
  EXPECT_EQ(elementsAt(meshes, 1, 2), 2u);
}

TEST(SharedDiagonals, ThatAreSegmentsOfOtherFacesAreSwapped) {
  DividedEdges divided = corner();
  divided.edges.resize(1);
  divided.edges[0].points = {1, 2};
  FaceMesh beside = cornerFace({0.5, 0, 1}, false);
  beside.elements = {Element{{VertexId(0), VertexId(1), VertexId(2), VertexId()}}};
  beside.uses = {{1, 0}};
  std::vector<FaceMesh> meshes{bridgeFace(0.2), beside};
  ASSERT_EQ(elementsAt(meshes, 1, 2), 3u);
  splitSharedDiagonals(divided, meshes);
  EXPECT_EQ(elementsAt(meshes, 1, 2), 1u);
  EXPECT_EQ(elementsAt({meshes[1]}, 1, 2), 1u);
}

TEST(SharedDiagonals, OfASingleFaceAreNoFault) {
  std::vector<FaceMesh> meshes{cornerFace({1.8, 0, 0.1}, false)};
  const auto before = meshes[0].elements[0].corners;
  splitSharedDiagonals(corner(), meshes);
  EXPECT_EQ(meshes[0].elements[0].corners, before);
}

}  // namespace
}  // namespace af2::geometry
