// That lower bounds of programs hold, and are as good as choosing rules needs.
#include "dsl/program/least_value.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dsl/load/rule_file.h"
#include "dsl/program/interval.h"

namespace af2::dsl {
namespace {

/// The lower bound of the cost of a rule at a level.
double leastCost(const std::string& cost, int level = 1) {
  const LoadedRules loaded = loadRulesFromText("test.af2", R"(af2 1;
ruleset "r" { elements quad; classes 1..4; score sum of 1 - scaled_jacobian; }
rule "q" quality 1 { new c = b + (0, 1), d = a + (0, 1); zone poly(a, b, c, d); quad a b c d; cost )" +
                                                               cost + "; }");
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  return loaded.rules ? loaded.rules->rules()[0].definition().cost->leastAt(level) : NAN;
}

TEST(LeastValue, OfLengthsAndAngles) {
  EXPECT_NEAR(leastCost("dist(a, b)"), 0, 1e-12);
  EXPECT_NEAR(leastCost("0.25 + 2 * dist(a, b)"), 0.25, 1e-12);
  EXPECT_NEAR(leastCost("abs(dist(a, b) - 1)"), 0, 1e-12);
  EXPECT_NEAR(leastCost("angle(a, b, b + (0, 2)) / 360deg"), 0, 1e-12);
  EXPECT_EQ(leastCost("-dist(a, b)"), -Interval::kInfinity);
}

TEST(LeastValue, OfALengthAndItsInverse) {
  EXPECT_NEAR(leastCost("max(dist(a, b), 1 / dist(a, b)) - 1"), 0, 1e-14);
  EXPECT_NEAR(leastCost("4 / dist(a, b) + dist(a, b)"), 4, 1e-13);
  // Rounding must not lift the bound above what a match can give.
  EXPECT_LE(leastCost("max(dist(a, b), 1 / dist(a, b))"), 1);
}

TEST(LeastValue, OfChoicesByWhatTheirConditionsSay) {
  const std::string k = "dist(a, b)";
  EXPECT_NEAR(leastCost("if " + k + " < 0.6 then 0.6 - " + k + " else 0.1"), 0, 1e-12);
  EXPECT_NEAR(leastCost("if " + k + " >= 2 then 2 * " + k + " else 3"), 3, 1e-12);
  // Of both branches the smaller one counts.
  EXPECT_NEAR(leastCost("if " + k + " < 1 then 5 else -2"), -2, 1e-12);
}

TEST(LeastValue, DependsOnTheLevel) {
  EXPECT_NEAR(leastCost("0.5 * q", 1), 0.5, 1e-12);
  EXPECT_NEAR(leastCost("0.5 * q", 3), 1.5, 1e-12);
}

}  // namespace
}  // namespace af2::dsl
