#include "geometry/charts/length_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace af2::geometry {
namespace {

TEST(LengthTable, IntegratesTheSpeed) {
  const auto table = LengthTable::make(1, 3, [](double t) { return 3 * t * t; });
  ASSERT_TRUE(table);
  EXPECT_EQ(table->lengthAt(1), 0);
  EXPECT_NEAR(table->lengthAt(2), 7, 1e-3);
  EXPECT_NEAR(table->lengthAt(3), 26, 1e-10);  // Simpson's rule is exact for this
}

TEST(LengthTable, GoesThereAndBackAlsoBeyondTheEnds) {
  const auto table = LengthTable::make(0, 2, [](double t) { return 1 + 50 * std::exp(-20 * t); });
  ASSERT_TRUE(table);
  for (const double t : {-0.3, 0.0, 0.01, 0.05, 0.7, 2.0, 2.4})
    EXPECT_NEAR(table->parameterAt(table->lengthAt(t)), t, 1e-13);
}

TEST(LengthTable, HasMoreNodesWhereTheSpeedChanges) {
  const auto exact = [](double t) { return t + 2.5 * (1 - std::exp(-20 * t)); };
  const auto table = LengthTable::make(0, 2, [](double t) { return 1 + 50 * std::exp(-20 * t); });
  ASSERT_TRUE(table);
  for (const double t : {0.002, 0.01, 0.05, 0.2, 1.1})
    EXPECT_NEAR(table->lengthAt(t), exact(t), 5e-4);
}

TEST(LengthTable, ThereIsNoneWhereTheSpeedVanishesOrIsNoNumber) {
  EXPECT_FALSE(LengthTable::make(0, 1, [](double t) { return t; }));
  EXPECT_FALSE(LengthTable::make(-1, 1, [](double t) { return t; }));
  EXPECT_FALSE(LengthTable::make(0, 1, [](double t) { return std::sqrt(t - 0.5); }));
  EXPECT_FALSE(LengthTable::make(0, 0, [](double) { return 1.0; }));
}

}  // namespace
}  // namespace af2::geometry
