// Surfaces of triangles whose roundings are far smaller than the elements.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/faceted/cones.h"
#include "geometry/faceted/mesh_faceted.h"
#include "geometry/faceted/patches.h"
#include "tests/geometry/faceted/faceted_mesh.h"
#include "tests/geometry/faceted/sheets.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

using testing::Closed;
using testing::grid;
using testing::limitsFor;

using std::numbers::pi;

/// A sheet 10 wide that turns down by a right angle around a cylinder; a row of points for every 15
/// degrees.
Facets bentSheet(double radius) {
  return grid(8, 4, Closed::InNeither, [=](std::uint32_t i, std::uint32_t j) {
    const double y = 2.5 * j;
    if (i == 0) return Point3{-10, y, radius};
    if (i == 8) return Point3{radius, y, -10};
    const double angle = (i - 1) * pi / 12;
    return Point3{radius * std::sin(angle), y, radius * std::cos(angle)};
  });
}

TEST(Blends, FarSmallerThanElementsBecomeEdges) {
  const PatchedFacets patched = findPatches(bentSheet(0.1), limitsFor(1));
  EXPECT_EQ(patched.patches.size(), 2u);
  for (const Patch& patch : patched.patches) {
    const Point3 normal = patched.normals[patch.triangles.front()];
    for (const std::uint32_t t : patch.triangles)
      EXPECT_GT(dot(patched.normals[t], normal), 1 - 1e-9) << "as beside the rounding";
  }
}

TEST(Blends, ThatElementsCanShowAreSmooth) {
  EXPECT_EQ(findPatches(bentSheet(1), limitsFor(1)).patches.size(), 1u);
}

TEST(Blends, AreNoEdgesWhereTheSurfaceTurnsLittle) {
  Facets sheet = bentSheet(0.1);
  for (std::uint32_t j = 0; j <= 4; ++j) {
    // The second half of the rounding goes on straight, so that it turns by 30 degrees.
    const Point3 from = sheet.vertices[3 * 5 + j];
    for (std::uint32_t i = 4; i <= 8; ++i)
      sheet.vertices[i * 5 + j] = from + (i - 3.0) * Point3{std::cos(pi / 6), 0, -std::sin(pi / 6)};
  }
  EXPECT_EQ(findPatches(sheet, limitsFor(1)).patches.size(), 1u);
}

TEST(Blends, RunStraightThroughIrregularTriangles) {
  // The diagonals of the rounding run to and fro.
  Facets sheet = bentSheet(0.1);
  for (std::size_t t = 0; t + 1 < sheet.triangles.size(); t += 4) {
    const auto [a, b, c] = sheet.triangles[t];
    const std::uint32_t d = sheet.triangles[t + 1][2];
    sheet.triangles[t] = {a, b, d};
    sheet.triangles[t + 1] = {b, c, d};
  }
  const PatchedFacets patched = findPatches(sheet, limitsFor(1));
  ASSERT_EQ(patched.patches.size(), 2u);
  double crease = 0;
  for (const FeatureCurve& curve : patched.curves) {
    const Point3 &p = patched.facets.vertices[curve.front()],
                 &q = patched.facets.vertices[curve.back()];
    if (std::abs(p.x) > 1 || std::abs(q.x) > 1 || std::abs(p.z) > 1 || std::abs(q.z) > 1) continue;
    for (std::size_t i = 1; i < curve.size(); ++i)
      crease += distance(patched.facets.vertices[curve[i - 1]], patched.facets.vertices[curve[i]]);
  }
  EXPECT_NEAR(crease, 10, 1e-9);
}

TEST(Blends, ThatAreAllOfASurfaceStayAsTheyAre) {
  // A thin half pipe with a flat strip along it, which is no surface that the rest leads to.
  const Facets pipe = grid(11, 4, Closed::InNeither, [](std::uint32_t i, std::uint32_t j) {
    const double angle = (i < 6 ? 18.0 * i : 18.0 * (i - 1.0)) * pi / 180;
    return Point3{(i < 6 ? 0 : 0.07) - 0.2 * std::cos(angle), 2.5 * j, 0.2 * std::sin(angle)};
  });
  const PatchedFacets patched = findPatches(pipe, limitsFor(1));
  for (std::size_t t = 0; t < pipe.triangles.size(); ++t) {
    const auto& [a, b, c] = pipe.triangles[t];
    const Point3& origin = pipe.vertices[a];
    const Point3 normal = unit(cross(pipe.vertices[b] - origin, pipe.vertices[c] - origin));
    EXPECT_GT(dot(patched.normals[t], normal), 1 - 1e-9);
  }
}

TEST(Blends, LetTheMeshKeepBothSides) {
  const ModelMesh result = testing::completeMesh(bentSheet(0.1), 1);
  EXPECT_EQ(result.faces.size(), 2u);
  EXPECT_GT(testing::leastAngle(result), 20);
}

TEST(Cones, CutASphereIntoPiecesThatHardlyTurn) {
  const Facets cap = grid(12, 48, Closed::InNeither, [](std::uint32_t i, std::uint32_t j) {
    const double polar = 0.15 + 2.4 * i / 12, around = 1.9 * pi * j / 48;
    return Point3{3 * std::sin(polar) * std::cos(around), 3 * std::sin(polar) * std::sin(around),
                  3 * std::cos(polar)};
  });
  const PatchedFacets whole = findPatches(cap, limitsFor(0.5));
  ASSERT_EQ(whole.patches.size(), 1u);
  const PatchedFacets cut =
      cutPatches(whole, coneBorders(whole, whole.patches[0], pi / 4, 0.5), limitsFor(0.5));
  ASSERT_GT(cut.patches.size(), 4u);
  EXPECT_LT(cut.patches.size(), 25u);
  for (const Patch& patch : cut.patches) {
    Point3 sum;
    for (const std::uint32_t t : patch.triangles) sum = sum + cut.normals[t];
    for (const std::uint32_t t : patch.triangles)
      EXPECT_GT(dot(cut.normals[t], unit(sum)), std::cos(80 * pi / 180));
  }
}

TEST(FacetSurface, IsAPlaneEvenIfASliverLiesOnOthers) {
  Facets square = grid(4, 4, Closed::InNeither, [](std::uint32_t i, std::uint32_t j) {
    return Point3{1.0 * i, 1.0 * j, 0};
  });
  // A vertex inside goes beyond the opposite side of one of its triangles.
  square.vertices[2 * 5 + 2] = {3.0001, 2.5, 0};
  const ModelMesh result = testing::completeMesh(square, 0.5);
  EXPECT_EQ(result.faces.size(), 1u);
  EXPECT_EQ(result.faces[0].surfaceType, "plane");
  EXPECT_NEAR(testing::areaOf(result), 16, 1e-9);
}

}  // namespace
}  // namespace af2::geometry
