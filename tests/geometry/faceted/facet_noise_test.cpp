// Scans: triangles far smaller than elements, and not where the surface was.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/base/stopwatch.h"
#include "geometry/faceted/cones.h"
#include "geometry/faceted/directions.h"
#include "geometry/mesh/quality.h"
#include "tests/geometry/faceted/faceted_mesh.h"
#include "tests/geometry/faceted/sheets.h"

namespace af2::geometry {
namespace {

using testing::Closed;
using testing::grid;
using testing::limitsFor;

using std::numbers::pi;

constexpr double kDegree = pi / 180;

/// Moves vertices by about so much in each direction.
void shake(Facets& facets, double length) {
  std::mt19937 random(1);
  const auto between = [&] { return length * (static_cast<double>(random()) / 2147483648.0 - 1); };
  for (Point3& p : facets.vertices) {
    const double x = between(), y = between(), z = between();
    p = p + Point3{x, y, z};
  }
}

/// Edges of triangles are about 0.25 long.
Facets torus() {
  return grid(75, 25, Closed::InBoth, [](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * pi * i / 75, v = 2 * pi * j / 25, r = 3 + std::cos(v);
    return Point3{r * std::cos(u), r * std::sin(u), std::sin(v)};
  });
}

/// Two slopes with a ridge, at right angles.
Facets roof() {
  return grid(32, 20, Closed::InNeither, [](std::uint32_t i, std::uint32_t j) {
    return Point3{0.25 * i, 0.25 * j, -std::abs(0.25 * i - 4)};
  });
}

TEST(Noise, IsNoneOnSmoothSurfacesNorAtEdges) {
  for (const Facets& facets : {torus(), roof()})
    for (const bool isRough : directionsOf(facets, limitsFor(0.8).sizeAt).isRough)
      ASSERT_FALSE(isRough);
}

TEST(Noise, MakesNoPatchesAndNoCorners) {
  Facets scan = torus();
  shake(scan, 0.08);
  FeatureLimits limits = limitsFor(0.8);
  const PatchedFacets patched = findPatches(scan, limits);
  EXPECT_EQ(patched.patches.size(), 2u) << "the halves of what is closed";
  EXPECT_LT(patched.curves.size(), 5u);
  limits.sizeAt = {};
  EXPECT_GT(findPatches(scan, limits).patches.size(), 10u) << "if nothing says what is small";
}

TEST(Noise, DoesNotHideEdges) {
  Facets scan = roof();
  shake(scan, 0.06);
  const PatchedFacets patched = findPatches(scan, limitsFor(0.8));
  ASSERT_EQ(patched.patches.size(), 2u);
  for (const Patch& patch : patched.patches)
    EXPECT_NEAR(static_cast<double>(patch.triangles.size()), 640, 30);
}

TEST(Noise, LeavesDetailsThatElementsCanShow) {
  Facets scan = torus();
  shake(scan, 0.08);
  EXPECT_GT(findPatches(scan, limitsFor(0.1)).patches.size(), 10u);
}

TEST(FacetedMeshing, MeshesScansAsIfTheyWereSmooth) {
  Facets scan = torus();
  shake(scan, 0.08);
  const ModelMesh mesh = testing::completeMesh(scan, 0.8);
  EXPECT_EQ(mesh.faces.size(), 2u);
  EXPECT_GT(measureQuality(mesh).minAngle, 3);
}

/// All pieces at the spikes of a plane join the one that is the plane.
TEST(Noise, IsCutIntoPiecesWithoutTakingLong) {
  const Facets sheet = grid(150, 150, Closed::InNeither, [](std::uint32_t i, std::uint32_t j) {
    return Point3{0.1 * i, 0.1 * j, i % 3 == 1 && j % 3 == 1 ? 0.3 : 0.0};
  });
  PatchedFacets patched{sheet, {}, {}, {}, {Patch{}}, {}};
  for (std::uint32_t t = 0; t < sheet.triangles.size(); ++t) {
    const auto& [a, b, c] = sheet.triangles[t];
    const Point3& origin = sheet.vertices[a];
    patched.normals.push_back(unit(cross(sheet.vertices[b] - origin, sheet.vertices[c] - origin)));
    patched.patches[0].triangles.push_back(t);
  }
  const Stopwatch watch;
  EXPECT_TRUE(coneBorders(patched, patched.patches[0], 45 * kDegree, 2).empty());
  EXPECT_LT(watch.seconds(), 2.0 * AF2_SLOWNESS);
}

}  // namespace
}  // namespace af2::geometry
