#include "dsl/proof/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "quad_rules.h"

namespace af2::dsl {
namespace {

const Coverage& coverageOfTriangles() {
  static const Coverage coverage = measureCoverage(*testing::triangleSet(), 10);
  return coverage;
}

std::size_t closest(const std::vector<double>& values, double value) {
  const auto nearer = [value](double p, double q) {
    return std::abs(p - value) < std::abs(q - value);
  };
  return static_cast<std::size_t>(std::min_element(values.begin(), values.end(), nearer) -
                                  values.begin());
}

TEST(Coverage, OfTheClassicalTrianglesIsGoodAroundUnitLength) {
  const CoverageMap& one = coverageOfTriangles().maps[0];
  EXPECT_EQ(one.level(closest(one.xs, 1), 0), 1);
  EXPECT_GT(one.level(closest(one.xs, 2.5), 0), 1);
}

TEST(Coverage, KnowsCornersOfSixtyDegrees) {
  const CoverageMap& two = coverageOfTriangles().maps[1];
  EXPECT_EQ(two.level(closest(two.xs, 60), closest(two.ys, 1)), 1);
  EXPECT_EQ(two.level(closest(two.xs, 120), closest(two.ys, 1)), 1);
  EXPECT_EQ(two.level(closest(two.xs, 180), closest(two.ys, 1)), 1);
}

TEST(Coverage, TellsSituationsThatCannotBe) {
  const CoverageMap& three = coverageOfTriangles().maps[2];
  EXPECT_EQ(three.level(closest(three.xs, 45), closest(three.ys, 45)), CoverageMap::kImpossible);
  EXPECT_NE(three.level(closest(three.xs, 90), closest(three.ys, 90)), CoverageMap::kImpossible);
}

TEST(Coverage, FindsWhatARuleSetLeavesOut) {
  RuleSetDefinition set = testing::triangleSetDefinition();
  set.rules = {testing::right60(), testing::fillTriangle()};
  const auto finding = findUncoveredSituations(measureCoverage(RuleSet(set), 3));
  ASSERT_TRUE(finding);
  EXPECT_EQ(idOf(finding->code), "N1");
  EXPECT_NE(finding->message.find("100 % of one edge"), std::string::npos) << finding->message;
  EXPECT_NE(finding->test.find("expect not stuck;"), std::string::npos);
}

TEST(Coverage, FindsNothingWhereEverythingIsTaken) {
  Coverage coverage = coverageOfTriangles();
  for (CoverageMap& map : coverage.maps)
    for (int& level : map.levels) level = std::max(level, 1);
  EXPECT_FALSE(findUncoveredSituations(coverage));
}

}  // namespace
}  // namespace af2::dsl
