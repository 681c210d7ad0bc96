#include "geometry/picture/raster.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

constexpr Rgb kRed{1, 0, 0}, kBlue{0, 0, 1};

/// A triangle over the whole image of 10 x 10 pixels.
std::array<Point3, 3> everywhereAt(double depth) {
  return {{{-10, -10, depth}, {40, -10, depth}, {-10, 40, depth}}};
}

TEST(Raster, ShowsTheNearerTriangleInAnyOrder) {
  for (const bool isNearFirst : {true, false}) {
    Raster raster(10, 10);
    raster.triangle(everywhereAt(isNearFirst ? 2 : 1), isNearFirst ? kRed : kBlue, {});
    raster.triangle(everywhereAt(isNearFirst ? 1 : 2), isNearFirst ? kBlue : kRed, {});
    EXPECT_EQ(raster.at(5, 5).red, 1);
    EXPECT_EQ(raster.at(5, 5).blue, 0);
  }
}

TEST(Raster, DrawsLinesAlongSidesInsideTheTriangle) {
  Raster raster(10, 10);
  raster.triangle({{{2, 2, 0}, {8, 2, 0}, {2, 8, 0}}}, kRed, {SideLine{1, 1}, {}, {}});
  EXPECT_EQ(raster.at(4, 2).red, kOutlineColor.red);  // along the first side
  EXPECT_EQ(raster.at(2, 4).red, 1);                  // along the last side
  EXPECT_EQ(raster.at(4, 1).green, 1);                // outside
}

TEST(Raster, IgnoresTrianglesThatAreSeenFromTheSideOrLieOutside) {
  Raster raster(4, 4);
  raster.triangle({{{0, 0, 0}, {4, 4, 0}, {2, 2, 5}}}, kRed, {});
  raster.triangle({{{-9, -9, 0}, {-5, -9, 0}, {-9, -5, 0}}}, kRed, {});
  raster.line({-9, -9, 0}, {-5, -5, 0}, 1, kRed);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(raster.at(i % 4, i / 4).green, 1);
}

TEST(Raster, DrawsHiddenLinesFaintly) {
  Raster raster(10, 10);
  raster.triangle(everywhereAt(0), kBlue, {});
  raster.line({0, 2, 1}, {10, 2, 1}, 2, kRed);
  raster.line({0, 8, -9}, {10, 8, -9}, 2, kRed);
  EXPECT_EQ(raster.at(5, 2).red, 1);
  EXPECT_GT(raster.at(5, 8).red, 0);
  EXPECT_LT(raster.at(5, 8).red, 0.5);
}

TEST(Raster, HalvesToMeansOfFourPixels) {
  Raster raster(2, 2);
  raster.line({0, 0.5, 0}, {1, 0.5, 0}, 0.5, {0, 0, 0});  // the upper left pixel
  EXPECT_EQ(raster.halved().width(), 1);
  EXPECT_DOUBLE_EQ(raster.halved().at(0, 0).red, 0.75);
}

TEST(QualityColors, EndAtZeroAndOne) {
  EXPECT_EQ(hexOf(qualityColor(-1)), "#a50026");
  EXPECT_EQ(hexOf(qualityColor(0)), "#a50026");
  EXPECT_EQ(hexOf(qualityColor(0.5)), "#fee090");
  EXPECT_EQ(hexOf(qualityColor(1)), "#4e83bd");
}

}  // namespace
}  // namespace af2::geometry
