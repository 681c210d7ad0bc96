#include "geometry/sizes/finer_inside.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/planar/mesh_planar.h"
#include "tests/geometry/planar/poly_text.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

constexpr double kTriangle = 0.4330127018922193;  // area, with sides of length 1

/// Rings around a point in a plane, up to where the size is 2.
double summed(double size, double radius, double growth) {
  constexpr double kStep = 1e-4;
  double sum = 0;
  for (double r = kStep / 2;; r += kStep) {
    const double here = size + growth * std::max(0., r - radius);
    if (here > 2) return sum;
    sum += 2 * std::numbers::pi * r * kStep / (kTriangle * here * here);
  }
}

/// Beyond what is expected without the point.
TEST(FinerInside, IntegratesSizesAroundAPoint) {
  for (const double radius : {0., 0.3})
    for (const double growth : {0.1, 0.5}) {
      const std::vector<SizeSource> point{{{7, 8, 9}, 0.05, radius}};
      const double whole = summed(0.05, radius, growth);
      const double reach = radius + (2 - 0.05) / growth;
      const double usual = std::numbers::pi * reach * reach / (kTriangle * 4);
      const double more = finerAround(point, growth, 2).around;
      EXPECT_LT(more, 1.001 * whole);
      EXPECT_GT(more, 0.999 * (whole - usual));
    }
}

TEST(FinerInside, AllowsNoMoreThanTheSmallestSizeOfAllPointsEverywhere) {
  const std::vector<SizeSource> crowd(10'000, SizeSource{{0, 0, 0}, 0.1});
  EXPECT_DOUBLE_EQ(finerAround(crowd, 0.3, 1).most(50), 50 + 100 * 50);
  EXPECT_EQ(finerAround({}, 0.3, 1).most(50), 50);
  const std::vector<SizeSource> coarse{{{0, 0, 0}, 1.5, 100}};
  EXPECT_EQ(finerAround(coarse, 0.3, 1).most(50), 50);
}

TEST(FinerInside, TakesBoxesAndFieldsForWholeFaces) {
  Sizes sizes;
  sizes.size = 1;
  EXPECT_EQ(finerInside(sizes).most(7), 7);
  sizes.sources.boxes = {{{0, 0, 0}, {1, 1, 1}, 0.5}};
  EXPECT_DOUBLE_EQ(finerInside(sizes).most(7), 7 + 4 * 7);
  sizes.sources.grids = {{{}, {1, 1, 1}, {2, 1, 1}, {3, 0.25}}};
  EXPECT_DOUBLE_EQ(finerInside(sizes).most(7), 7 + 4 * 7 + 16 * 7);
  sizes.sources.cells = {
      {{{}}, {0.2}, {{0, SizeCells::kNone, SizeCells::kNone, SizeCells::kNone}}}};
  EXPECT_DOUBLE_EQ(finerInside(sizes).most(7), 7 + 4 * 7 + 16 * 7 + 25 * 7);
  sizes.minSize = 0.5;
  EXPECT_DOUBLE_EQ(finerInside(sizes).most(7), 7 + 3 * 4 * 7);
  sizes.function = [](const Point3&) { return 1; };
  EXPECT_EQ(finerInside(sizes).most(7), kAnySizes.most(7));
}

/// Sizes grow so slowly that the point makes a hundred times as many elements as the square.
TEST(FinerInside, IsAboutWhatAMeshHas) {
  MeshingOptions options;
  options.sizes.size = 4;
  options.sizes.growth = 0.05;
  options.sizes.sources.points = {{{20, 20, 0}, 0.05}};
  const ModelMesh mesh = meshPlanar(
      testing::polyOf(
          "4 2 0 0\n1 0 0\n2 40 0\n3 40 40\n4 0 40\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n"),
      AF2Algorithm(testing::triangleSet()), options);
  ASSERT_EQ(mesh.faces[0].status, FaceStatus::Complete);
  const double most = finerInside(options.sizes).most(1600 / (kTriangle * 16));
  EXPECT_LT(static_cast<double>(mesh.elements.size()), 1.5 * most);
  EXPECT_GT(static_cast<double>(mesh.elements.size()), 0.3 * most);
}

}  // namespace
}  // namespace af2::geometry
