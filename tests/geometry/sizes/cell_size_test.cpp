#include "geometry/sizes/cell_size.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/base/error.h"
#include "geometry/sizes/size_sources.h"

namespace af2::geometry {
namespace {

constexpr std::uint32_t kNone = SizeCells::kNone;
constexpr double kAnyGrowth = 100;

/// At (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1) the size is 1 + x + 2 y + 3 z.
SizeCells corner(std::vector<std::array<std::uint32_t, 4>> cells) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1, 2, 3, 4}, std::move(cells)};
}

TEST(CellSize, IsLinearWithinATetrahedron) {
  const CellSize size(corner({{0, 1, 2, 3}}), kAnyGrowth);
  EXPECT_NEAR(size.at({0.2, 0.3, 0.1}), 2.1, 1e-14);
  EXPECT_DOUBLE_EQ(size.at({0, 0, 1}), 4);
}

TEST(CellSize, IsThatOfTheNearestPointOutside) {
  const CellSize tetrahedron(corner({{0, 1, 2, 3}}), kAnyGrowth);
  EXPECT_NEAR(tetrahedron.at({0.2, 0.3, -5}), 1.8, 1e-14);
  EXPECT_NEAR(tetrahedron.at({9, -1, -1}), 2, 1e-14);
  const CellSize triangle(corner({{0, 1, 2, kNone}}), kAnyGrowth);
  EXPECT_NEAR(triangle.at({0.2, 0.3, 7}), 1.8, 1e-14);
  EXPECT_NEAR(triangle.at({1, 1, 0}), 2.5, 1e-14);
  const CellSize segment(corner({{0, 1, kNone, kNone}}), kAnyGrowth);
  EXPECT_NEAR(segment.at({0.25, 8, 0}), 1.25, 1e-14);
  const CellSize points(corner({{0, kNone, kNone, kNone}, {3, kNone, kNone, kNone}}), kAnyGrowth);
  EXPECT_EQ(points.at({0, 0, 0.4}), 1);
  EXPECT_EQ(points.at({0, 0, 0.6}), 4);
}

TEST(CellSize, IsTheSameAsTryingAllCells) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0, 1);
  const auto place = [&] { return Point3{number(random), number(random), number(random)}; };
  SizeCells all;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const Point3 middle = 4.0 * place();
    for (int k = 0; k < 3; ++k) {
      all.vertices.push_back(middle + 0.3 * place());
      all.sizes.push_back(1 + number(random));
    }
    all.cells.push_back({3 * i, 3 * i + 1, 3 * i + 2, kNone});
  }
  const CellSize size(all, kAnyGrowth);
  for (int i = 0; i < 200; ++i) {
    const Point3 p = 4.0 * place();
    double best = 1e9, wanted = 0;
    for (const auto& cell : all.cells) {  // the nearest of many points of each
      for (int a = 0; a <= 40; ++a)
        for (int b = 0; a + b <= 40; ++b) {
          const double u = a / 40., v = b / 40., w = 1 - u - v;
          const Point3 q =
              u * all.vertices[cell[0]] + v * all.vertices[cell[1]] + w * all.vertices[cell[2]];
          if (distance(p, q) >= best) continue;
          best = distance(p, q);
          wanted = u * all.sizes[cell[0]] + v * all.sizes[cell[1]] + w * all.sizes[cell[2]];
        }
    }
    EXPECT_NEAR(size.at(p), wanted, 0.15) << i;
  }
}

TEST(CellSize, GrowsNoFasterThanItMay) {
  SizeCells row;
  for (std::uint32_t i = 0; i < 5; ++i) {
    row.vertices.push_back({i * 1.0, 0, 0});
    row.sizes.push_back(i == 2 ? 0.1 : 5);
    if (i > 0) row.cells.push_back({i - 1, i, kNone, kNone});
  }
  const CellSize size(row, 0.5);
  EXPECT_NEAR(size.at({2, 0, 0}), 0.1, 1e-15);
  EXPECT_NEAR(size.at({3, 0, 0}), 0.6, 1e-15);
  EXPECT_NEAR(size.at({0, 0, 0}), 1.1, 1e-15);
}

TEST(CellSize, CountsAmongTheSourcesIfItIsSmaller) {
  SizeSources sources;
  sources.cells = {corner({{0, 1, 2, kNone}})};
  sources.boxes = {{{0, 0, 0}, {1, 1, 0}, 1.5}};
  const PositionSize size = sizeFrom(sources, kAnyGrowth);
  EXPECT_NEAR(size.at({0.1, 0.1, 0}), 1.3, 1e-14);
  EXPECT_NEAR(size.at({0.1, 0.8, 0}), 1.5, 1e-14);
}

TEST(CellSize, RefusesWhatIsNone) {
  EXPECT_THROW(checkCells({}), InputError);
  EXPECT_THROW(checkCells(corner({{0, 1, 7, kNone}})), InputError);
  EXPECT_THROW(checkCells(corner({{kNone, kNone, kNone, kNone}})), InputError);
  SizeCells negative = corner({{0, 1, 2, kNone}});
  negative.sizes[1] = -1;
  EXPECT_THROW(checkCells(negative), InputError);
  EXPECT_NO_THROW(checkCells(corner({{0, 1, 2, kNone}})));
}

}  // namespace
}  // namespace af2::geometry
