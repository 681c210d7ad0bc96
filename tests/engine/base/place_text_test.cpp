#include "engine/base/place_text.h"

#include <gtest/gtest.h>

namespace af2 {
namespace {

TEST(TextOfAPlace, HasAsManyDigitsAsItNeeds) {
  EXPECT_EQ(textOf(Point3{1, -2.5, 1e-7}), "(1, -2.5, 1e-07)");
  EXPECT_EQ(textOf(Point2{1.0 / 3, 1e20}), "(0.333333333, 1e+20)");
  EXPECT_EQ(textOf(1.0 / 3, 3), "0.333");
}

TEST(TextOfAPlace, TellsOfSmallModelsAsOfLargeOnes) {
  EXPECT_EQ(textOf(Point3{1.25e-9, 0, -3e-12}), "(1.25e-09, 0, -3e-12)");
}

}  // namespace
}  // namespace af2
