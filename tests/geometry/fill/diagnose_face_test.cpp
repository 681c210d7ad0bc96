#include "geometry/fill/diagnose_face.h"

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

FaceDiagnosis diagnosisOf(const Mesh& mesh, double area, const IsLeast& isLeast = {}) {
  FaceBoundary boundary;
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  auto& loop = boundary.input.loops.emplace_back();
  for (std::uint32_t i = 0; i < count; i += 2) loop.push_back({VertexId(i), mesh.vertices[i]});
  for (std::uint32_t i = count; i > 0; i -= 2)
    loop.push_back({VertexId(i - 1), mesh.vertices[i - 1]});
  boundary.input.vertexCount = count;
  return diagnoseMesh(mesh, boundary, false, area, 0, isLeast);
}

TEST(FaceDiagnosis, IsNoneWhereAMeshIsAsItShouldBe) {
  const FaceDiagnosis diagnosis = diagnosisOf(pleated(40, 0), 40);
  EXPECT_TRUE(diagnosis.places.empty());
  EXPECT_FALSE(diagnosis.isBad || diagnosis.hasBadAngle || diagnosis.hasWrongArea);
}

TEST(FaceDiagnosis, AsksForShorterEdgesWhereTheAreaIsOff) {
  const FaceDiagnosis diagnosis = diagnosisOf(pleated(40, 0.5), 40);  // 1.12 times as large
  EXPECT_TRUE(diagnosis.isBad);
  EXPECT_FALSE(diagnosis.hasWrongArea);
  ASSERT_FALSE(diagnosis.places.empty());
  for (const SizeSource& place : diagnosis.places) EXPECT_LT(place.size, 1.5);
}

/// It would not get them, and be meshed again for nothing.
TEST(FaceDiagnosis, AsksForNothingWhereEdgesAreAsShortAsTheyMayBe) {
  const IsLeast isLeft = [](const SurfacePoint& point) { return point.position.x <= 20; };
  const FaceDiagnosis all = diagnosisOf(pleated(40, 0.5), 40);
  const FaceDiagnosis right = diagnosisOf(pleated(40, 0.5), 40, isLeft);
  EXPECT_TRUE(right.isBad) << "it stays as poor as it is";
  EXPECT_EQ(right.poorness, all.poorness);
  ASSERT_FALSE(right.places.empty());
  EXPECT_LT(right.places.size(), 0.6 * static_cast<double>(all.places.size()));
  for (const SizeSource& place : right.places) EXPECT_GT(place.position.x, 20);
}

TEST(FaceDiagnosis, AsksForNothingAtSharpAnglesWhereEdgesAreAsShortAsTheyMayBe) {
  Mesh mesh = pleated(40, 0);
  mesh.vertices[1].position.y = 0.02;
  const auto placesWith = [&](const IsLeast& isLeast) {
    return diagnosisOf(mesh, 0, isLeast).places.size();
  };
  EXPECT_GT(placesWith({}), 0u);
  EXPECT_GT(placesWith([](const SurfacePoint& point) { return point.position.x > 0.5; }), 0u);
  EXPECT_EQ(placesWith([](const SurfacePoint&) { return true; }), 0u);
}

/// Else such a mesh would be kept as the better one and fall at the last check.
TEST(FaceDiagnosis, KnowsMeshesThatWillNotPass) {
  EXPECT_TRUE(diagnosisOf(pleated(40, 1.5), 40).hasWrongArea);
  EXPECT_TRUE(diagnosisOf(pleated(40, 0), 60).hasWrongArea);
  EXPECT_FALSE(diagnosisOf(pleated(10, 1.5), 10).hasWrongArea);  // a few elements may be far off
}

TEST(FaceDiagnosis, AsksForShorterEdgesAroundTriangles) {
  Mesh mesh = pleated(3, 0);
  mesh.elements = {{{VertexId(0), VertexId(2), VertexId(3), VertexId(1)}}};
  FaceDiagnosis diagnosis;
  askForRoom(mesh, {}, diagnosis);
  EXPECT_TRUE(diagnosis.places.empty());
  EXPECT_EQ(diagnosis.poorness, 0);
  mesh.elements.push_back({{VertexId(2), VertexId(4), VertexId(5)}});
  mesh.elements.push_back({{VertexId(2), VertexId(5), VertexId(3)}});
  askForRoom(mesh, {}, diagnosis);
  ASSERT_EQ(diagnosis.places.size(), 6u);
  for (const SizeSource& place : diagnosis.places) {
    EXPECT_GE(place.position.x, 1);
    EXPECT_LT(place.size, 1);
  }
  EXPECT_GT(diagnosis.poorness, 0);
  EXPECT_FALSE(diagnosis.isBad) << "the mesh is fit for use: it is tried once";
}

}  // namespace
}  // namespace af2::geometry
