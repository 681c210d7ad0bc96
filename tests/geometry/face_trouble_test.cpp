#include "geometry/face_trouble.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

/// A strip of squares of side 1 across the x axis, two triangles each; at every other line across
/// it, it lies so much higher.
Mesh pleated(int squares, double height) {
  Mesh mesh;
  for (int i = 0; i <= squares; ++i)
    for (const double y : {0.0, 1.0})
      mesh.vertices.push_back({{static_cast<double>(i), y, i % 2 * height}, {0, 0, 1}, 0, 0});
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(squares); ++i) {
    const VertexId a(2 * i), b(2 * i + 2), c(2 * i + 3), d(2 * i + 1);
    mesh.elements.push_back({{a, b, c}});
    mesh.elements.push_back({{a, c, d}});
  }
  return mesh;
}

FaceTrouble troubleOf(const Mesh& mesh, double area) {
  FaceBoundary boundary;
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  auto& loop = boundary.input.loops.emplace_back();
  for (std::uint32_t i = 0; i < count; i += 2) loop.push_back({VertexId(i), mesh.vertices[i]});
  for (std::uint32_t i = count; i > 0; i -= 2)
    loop.push_back({VertexId(i - 1), mesh.vertices[i - 1]});
  boundary.input.vertexCount = count;
  return troubleOfMesh(mesh, boundary, false, area, 0);
}

TEST(FaceTrouble, IsNoneWhereAMeshIsAsItShouldBe) {
  const FaceTrouble trouble = troubleOf(pleated(40, 0), 40);
  EXPECT_TRUE(trouble.places.empty());
  EXPECT_FALSE(trouble.isBad || trouble.hasBadAngle || trouble.hasWrongArea);
}

TEST(FaceTrouble, AsksForShorterEdgesWhereTheAreaIsOff) {
  const FaceTrouble trouble = troubleOf(pleated(40, 0.5), 40);  // 1.12 times as large
  EXPECT_TRUE(trouble.isBad);
  EXPECT_FALSE(trouble.hasWrongArea);
  ASSERT_FALSE(trouble.places.empty());
  for (const SizeSource& place : trouble.places) EXPECT_LT(place.size, 1.5);
}

/// Else such a mesh would be kept as the better one and fall at the last check.
TEST(FaceTrouble, KnowsMeshesThatWillNotPass) {
  EXPECT_TRUE(troubleOf(pleated(40, 1.5), 40).hasWrongArea);
  EXPECT_TRUE(troubleOf(pleated(40, 0), 60).hasWrongArea);
  EXPECT_FALSE(troubleOf(pleated(10, 1.5), 10).hasWrongArea);  // a few elements may be far off
}

}  // namespace
}  // namespace af2::geometry
