// Patches of triangles drawn in a plane, and meshed there.
#include "geometry/faceted/flattening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/predicates.h"
#include "geometry/faceted/facet_surface.h"
#include "geometry/faceted/faceted_model.h"
#include "geometry/faceted/mesh_faceted.h"
#include "geometry/faceted/sparse_system.h"
#include "tests/geometry/faceted/faceted_mesh.h"
#include "tests/geometry/faceted/sheets.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

using testing::Closed;
using testing::grid;

using std::numbers::pi;

/// Part of a tube of radius 1.
Facets openTube(double degrees, double length, std::uint32_t rows) {
  return grid(22, rows, Closed::InNeither, [=](std::uint32_t i, std::uint32_t j) {
    const double angle = degrees * pi / 180 * i / 22;
    return Point3{std::sin(angle), length * j / rows, std::cos(angle)};
  });
}

Facets ring(double length, std::uint32_t rows) {
  return grid(24, rows, Closed::InFirst, [=](std::uint32_t i, std::uint32_t j) {
    const double angle = 2 * pi * i / 24;
    return Point3{std::sin(angle), length * j / rows, std::cos(angle)};
  });
}

/// The area of the picture, if no triangle is turned over; else 0.
double areaOfPicture(const Facets& facets) {
  const auto places = flatten(facets.vertices, facets.triangles);
  if (!places || places->size() != facets.vertices.size()) return 0;
  double area = 0;
  for (const auto& [a, b, c] : facets.triangles) {
    const Point2 p = (*places)[a], q = (*places)[b], r = (*places)[c];
    if (orientation(p, q, r) != Turn::Left) return 0;
    area += cross(q - p, r - p) / 2;
  }
  return area;
}

TEST(FacetSurface, IsMadeAgainOnlyForAPatchThatHasChanged) {
  MeshingOptions options;
  options.sizes.size = 0.5;
  PatchedFacets tube = findPatches(openTube(170, 2, 10), testing::limitsFor(0.5));
  MadeFaces made;
  const DomainModel first = modelOf(tube, options, &made), second = modelOf(tube, options, &made);
  ASSERT_EQ(first.faces.size(), 1u);
  EXPECT_EQ(first.faces[0].surface, second.faces[0].surface);
  tube.normals[7] = -1 * tube.normals[7];
  EXPECT_NE(modelOf(tube, options, &made).faces[0].surface, first.faces[0].surface);
}

TEST(FacetSurface, IsOfAPatchOnlyIfAllOfItIsTheSame) {
  PatchedFacets tube = findPatches(openTube(170, 2, 10), testing::limitsFor(0.5));
  ASSERT_EQ(tube.patches.size(), 1u);
  const FacetSurface surface(tube, tube.patches[0], FacetSurface::Drawing::IfPossible);
  EXPECT_TRUE(surface.isOf(tube, tube.patches[0]));
  Patch part = tube.patches[0];
  part.triangles.pop_back();
  EXPECT_FALSE(surface.isOf(tube, part));
  std::ranges::reverse(part.triangles = tube.patches[0].triangles);
  EXPECT_FALSE(surface.isOf(tube, part));
  PatchedFacets turned = tube;
  turned.normals[7] = -1 * turned.normals[7];
  EXPECT_FALSE(surface.isOf(turned, turned.patches[0]));
  PatchedFacets moved = tube;
  moved.facets.vertices[moved.facets.triangles[9][1]].z += 1e-9;
  EXPECT_FALSE(surface.isOf(moved, moved.patches[0]));
}

TEST(SparseSystem, SolvesWhatIsNotSymmetric) {
  // Each unknown is a mean of its neighbours that leans to the right; the ends are 0 and 1.
  constexpr std::uint32_t kCount = 200;
  std::vector<SparseEntry> matrix;
  std::vector<Point2> right(kCount);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    if (i > 0) matrix.push_back({i, i - 1, -0.4});
    matrix.push_back({i, i, 1});
    if (i + 1 < kCount) matrix.push_back({i, i + 1, -0.6});
  }
  right[kCount - 1] = {0.6, 1.2};
  const auto x = solveSparse(matrix, right);
  ASSERT_TRUE(x);
  const double ratio = 0.4 / 0.6, whole = 1 - std::pow(ratio, kCount + 1);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    EXPECT_NEAR((*x)[i].x, (1 - std::pow(ratio, i + 1)) / whole, 1e-12);
    EXPECT_NEAR((*x)[i].y, 2 * (*x)[i].x, 1e-12);
  }
}

TEST(SparseSystem, MayHaveNoUnknowns) { EXPECT_TRUE(solveSparse({}, {})); }

TEST(SparseSystem, HasNoSolutionIfItIsSingular) {
  EXPECT_FALSE(solveSparse({{0, 0, 1}, {0, 1, -1}, {1, 0, -1}, {1, 1, 1}}, {{1, 0}, {2, 0}}));
}

TEST(Flattening, DrawsWhatCurlsUpWithoutFolds) {
  const double area = areaOfPicture(openTube(330, 10, 12));
  EXPECT_GT(area, 0);
  EXPECT_NEAR(area, 330 * pi / 180 * 10, 0.1 * area);
}

TEST(Flattening, DrawsRingsAroundTheirHole) {
  EXPECT_GT(areaOfPicture(ring(2, 4)), 0);
  EXPECT_GT(areaOfPicture(ring(8, 16)), 0) << "most of it is far from the longest boundary";
}

TEST(Flattening, RefusesWhatIsNoDisc) {
  const Facets torus = grid(12, 8, Closed::InFirst, [](std::uint32_t i, std::uint32_t j) {
    const double u = pi * i / 6, v = pi * j / 4, r = 3 + std::cos(v);
    return Point3{r * std::cos(u), r * std::sin(u), std::sin(v)};
  });
  // Sewn together by positions: rows 0 and 8 are the same.
  Facets closed = torus;
  for (auto& triangle : closed.triangles)
    for (std::uint32_t& v : triangle)
      if (v % 9 == 8) v -= 8;
  std::vector<Point3> vertices = closed.vertices;
  EXPECT_FALSE(flatten(vertices, closed.triangles)) << "it has no boundary";
  // One triangle less makes a boundary, but no disc.
  closed.triangles.pop_back();
  EXPECT_FALSE(flatten(vertices, closed.triangles));
}

TEST(FacetSurface, HasItsPointsWhereTheyAreDrawn) {
  FeatureLimits limits;
  limits.angle = 40 * pi / 180;
  const PatchedFacets patched = findPatches(openTube(200, 5, 6), limits);
  ASSERT_EQ(patched.patches.size(), 1u);
  const FacetSurface surface(patched, patched.patches[0], FacetSurface::Drawing::IfPossible);
  ASSERT_TRUE(surface.isDrawn());
  for (const Point3& p : patched.facets.vertices) {
    const SurfacePoint there = surface.nearest(p);
    EXPECT_NEAR(distance(surface.pointAt(there.u, there.v).position, p), 0, 1e-9);
    const SurfaceFrame frame = surface.frameAt(there.u, there.v);
    EXPECT_GT(dot(cross(frame.du, frame.dv), there.normal), 0.05);
  }
}

/// Far narrower than the size, and turning by most of a circle across their width.
TEST(FacetedMeshing, FillsLongStripsThatCurlUp) {
  for (const double degrees : {200.0, 300.0})
    for (const double size : {20.0, 30.0}) {
      const double area = degrees * pi / 180 * 400;
      EXPECT_NEAR(testing::areaOf(testing::completeMesh(openTube(degrees, 400, 1), size)), area,
                  0.2 * area);
    }
}

/// A tube a hundred times longer than wide comes in two halves, not in slices.
TEST(Patches, OfLongTubesAreCutAlongThem) {
  const Facets hoop = grid(200, 12, Closed::InFirst, [](std::uint32_t i, std::uint32_t j) {
    const double u = pi * i / 100, v = pi * j / 6, r = 50 + 0.5 * std::cos(v);
    return Point3{r * std::cos(u), r * std::sin(u), 0.5 * std::sin(v)};
  });
  Facets closed = hoop;
  for (auto& triangle : closed.triangles)
    for (std::uint32_t& v : triangle)
      if (v % 13 == 12) v -= 12;
  FeatureLimits limits;
  limits.angle = 40 * pi / 180;
  EXPECT_EQ(findPatches(closed, limits).patches.size(), 2u);
}

}  // namespace
}  // namespace af2::geometry
