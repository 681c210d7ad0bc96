#include "geometry/sizes/size_sources.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

SizeGrid stepGrid() {
  SizeGrid grid{{-1, 0, 0}, {0.5, 1, 1}, {5, 2, 1}, {}};
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 5; ++i) grid.sizes.push_back(i < 2 ? 0.1 : 5);
  return grid;
}

SizeSources mixture() {
  SizeSources sources;
  sources.points = {{{0, 0, 0}, 0.1}, {{2, 1, 0}, 0.05, 0.5}};
  sources.boxes = {{{-2, -2, -2}, {-1, 0, 1}, 0.2}};
  sources.grids = {stepGrid()};
  return sources;
}

TEST(SizeSources, HaveTheirSizeWithinAndGrowOutside) {
  SizeSources sources;
  sources.points = {{{5, 0, 0}, 0.1, 1}};
  sources.boxes = {{{0, 0, 0}, {1, 1, 1}, 0.2}};
  const PositionSize size = sizeFrom(sources, 0.5);
  EXPECT_DOUBLE_EQ(size.at({5.5, 0, 0}), 0.1);
  EXPECT_DOUBLE_EQ(size.at({5, 3, 0}), 1.1);
  EXPECT_DOUBLE_EQ(size.at({0.3, 1, 0.9}), 0.2);
  EXPECT_DOUBLE_EQ(size.at({0.5, 1.4, 1.3}), 0.45);
}

TEST(SizeSources, InterpolateAField) {
  SizeSources sources;
  sources.grids = {{{0, 0, 0}, {1, 2, 4}, {2, 2, 2}, {1, 2, 1, 2, 1, 2, 1, 2}}};
  const PositionSize size = sizeFrom(sources, 10);
  EXPECT_DOUBLE_EQ(size.at({0.25, 1.3, 3.1}), 1.25);
  EXPECT_DOUBLE_EQ(size.at({1, 2, 4}), 2);
  EXPECT_DOUBLE_EQ(size.at({1.5, 2, 4}), 7);
}

TEST(SizeSources, NeverGrowFasterThanAsked) {
  const double growth = 0.3;
  const PositionSize size = sizeFrom(mixture(), growth);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-3, 3), small(-0.2, 0.2);
  for (int i = 0; i < 5000; ++i) {
    const Point3 p{any(random), any(random), any(random)};
    const Point3 q = p + Point3{small(random), small(random), small(random)};
    // Between the nodes of a field the steepest direction may be a diagonal.
    EXPECT_LE(size.at(q), size.at(p) + growth * std::sqrt(3.0) * distance(p, q) + 1e-9);
  }
}

TEST(SizeSources, AreInfiniteWhereThereAreNone) {
  EXPECT_EQ(sizeFrom({}, 0.4).at({1, 2, 3}), kInfinite);
}

TEST(SizeSources, RefuseWhatMakesNoSense) {
  SizeSources sources;
  sources.points = {{{0, 0, 0}, 0}};
  EXPECT_THROW(sizeFrom(sources, 0.4), InputError);
  sources = {};
  sources.boxes = {{{1, 0, 0}, {0, 1, 1}, 1}};
  EXPECT_THROW(sizeFrom(sources, 0.4), InputError);
  sources = {};
  sources.grids = {stepGrid()};
  sources.grids[0].sizes.pop_back();
  EXPECT_THROW(sizeFrom(sources, 0.4), InputError);
}

TEST(PositionSize, IsMadeFromACallableForOneOrForManyPositions) {
  const PositionSize one = [](const Point3& p) { return p.x; };
  int calls = 0;
  const PositionSize many = [&](std::span<const Point3> at, std::span<double> sizes) {
    ++calls;
    for (std::size_t i = 0; i < at.size(); ++i) sizes[i] = at[i].x;
  };
  const std::vector<Point3> at{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  std::vector<double> fromOne(3), fromMany(3);
  one.at(at, fromOne);
  many.at(at, fromMany);
  EXPECT_EQ(fromOne, fromMany);
  EXPECT_EQ(calls, 1);
  EXPECT_FALSE(PositionSize());
}

TEST(PositionSize, TellsWhereItIsNotPositive) {
  const PositionSize size = [](const Point3& p) { return p.x; };
  try {
    size.at({-1, 2, 3});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("(-1, 2, 3)"), std::string::npos);
  }
  EXPECT_THROW(size.at({std::nan(""), 0, 0}), InputError);
}

}  // namespace
}  // namespace af2::geometry
