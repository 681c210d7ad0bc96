#include "dsl/shapes/path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace af2::dsl::shapes {
namespace {

bool simple(std::vector<PathStep> path) {
  const auto steps = stepsOf(Shape::poly(std::move(path)));
  return steps && isSimple(*steps);
}

double winding(std::vector<PathStep> path) {
  return windingOf(*stepsOf(Shape::poly(std::move(path))));
}

TEST(IsSimple, AllowsNeighborsAndStraightCorners) {
  EXPECT_TRUE(simple({{{0, 0}, {}}, {{1, 0}, {}}, {{2, 0}, {}}, {{2, 2}, {}}, {{0, 2}, {}}}));
}

TEST(IsSimple, RefusesTouchingCornersSpikesAndOverlaps) {
  EXPECT_FALSE(simple({{{0, 0}, {}}, {{4, 0}, {}}, {{4, 2}, {}}, {{2, 0}, {}}, {{0, 2}, {}}}));
  EXPECT_FALSE(simple({{{0, 0}, {}}, {{4, 0}, {}}, {{2, 0}, {}}, {{2, 2}, {}}}));
  EXPECT_FALSE(
      simple({{{0, 0}, {}}, {{1, 1}, {}}, {{2, 0}, {}}, {{2, 2}, {}}, {{1, 1}, {}}, {{0, 2}, {}}}));
  EXPECT_FALSE(simple({{{0, 0}, {}}, {{1, 0}, {}}}));
}

TEST(IsSimple, TellsAnArcThatTouchesALineFromOneThatComesClose) {
  const auto arch = [](double top) {  // under a roof of height 5
    return std::vector<PathStep>{{{-5, 0}, Point2{3, 4}}, {{-6, 0}, {}}, {{-6, top}, {}},
                                 {{6, top}, {}},          {{6, 0}, {}},  {{5, 0}, {}}};
  };
  EXPECT_FALSE(simple(arch(5)));
  EXPECT_FALSE(simple(arch(4.5)));
  EXPECT_TRUE(simple(arch(std::nextafter(5.0, 6.0))));
}

TEST(IsSimple, TellsArcsThatTouch) {
  // Two arches, one below the other: radius 5 about the origin, and one through (0, top).
  const auto arches = [](double top) {
    return std::vector<PathStep>{
        {{5, 0}, {}}, {{-5, 0}, Point2{3, 4}}, {{-4, 0}, {}}, {{4, 0}, Point2{0, top}}};
  };
  EXPECT_TRUE(simple(arches(4)));
  EXPECT_FALSE(simple(arches(5)));
  EXPECT_FALSE(simple(arches(6)));
  EXPECT_TRUE(simple(arches(std::nextafter(5.0, 4.0))));
}

TEST(IsSimple, AllowsArcsOfOneCircleSideBySide) {
  EXPECT_TRUE(simple({{{-5, 0}, Point2{3, 4}}, {{5, 0}, Point2{-3, -4}}}));
  EXPECT_TRUE(simple({{{3, 4}, Point2{4, 3}}, {{-3, 4}, Point2{0, 5}}, {{5, 0}, Point2{-3, -4}}}));
  EXPECT_FALSE(simple({{{-5, 0}, Point2{3, 4}}, {{5, 0}, Point2{0, 5}}}));
}

TEST(IsSimple, AllowsArcsThatMeetSmoothly) {
  // An S between two straight ends.
  EXPECT_TRUE(simple(
      {{{0, 0}, {}}, {{2, 0}, Point2{1, 1}}, {{4, 0}, Point2{3, -1}}, {{4, 3}, {}}, {{0, 3}, {}}}));
}

TEST(IsSimple, SeesAnArcThatCrossesItsNeighbor) {
  EXPECT_FALSE(simple({{{0, 0}, {}}, {{4, 0}, {}}, {{1, 2}, Point2{2, -1}}}));
  EXPECT_FALSE(simple({{{0, 0}, {}}, {{6, 0}, Point2{3, 3}}, {{2, 6}, Point2{3, 2}}}));
}

TEST(Winding, IsTwiceTheArea) {
  EXPECT_NEAR(winding({{{-5, 0}, Point2{3, 4}}, {{5, 0}, Point2{-3, -4}}}), 50 * M_PI, 1e-10);
  EXPECT_NEAR(winding({{{5, 0}, Point2{3, 4}}, {{-5, 0}, Point2{-3, -4}}}), -50 * M_PI, 1e-10);
  EXPECT_NEAR(winding({{{0, 0}, {}}, {{2, 0}, {}}, {{2, 1}, {}}}), 2, 1e-12);
  EXPECT_NEAR(winding({{{2, 1}, {}}, {{2, 0}, {}}, {{0, 0}, {}}}), -2, 1e-12);
}

}  // namespace
}  // namespace af2::dsl::shapes
