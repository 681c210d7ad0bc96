#include "engine/rule/rule_set.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/base/error.h"
#include "tests/support/triangle_rules.h"

namespace af2 {
namespace {

using namespace af2::testing;

std::string errorOf(RuleSetDefinition definition) {
  try {
    RuleSet set(std::move(definition));
    return "no error";
  } catch (const InputError& e) {
    return e.what();
  }
}

TEST(RuleSet, TakesTheClassicalRules) {
  const RuleSet set(triangleSetDefinition());
  EXPECT_EQ(set.name(), "triangles");
  EXPECT_EQ(set.rules().size(), 12u);
  EXPECT_TRUE(set.makesTriangles());
  EXPECT_FALSE(set.makesQuads());
}

TEST(RuleSet, GivesTheMatchToleranceByLevelAndTheNearestOneOutside) {
  const RuleSet set(triangleSetDefinition());
  EXPECT_DOUBLE_EQ(set.matchTolerance(1), .8);
  EXPECT_DOUBLE_EQ(set.matchTolerance(50), 15.5);
  EXPECT_DOUBLE_EQ(set.matchTolerance(0), .8);
  EXPECT_DOUBLE_EQ(set.matchTolerance(51), 15.5);
}

TEST(RuleSetRejection, OfNoRules) {
  RuleSetDefinition d = triangleSetDefinition();
  d.rules.clear();
  EXPECT_EQ(errorOf(d), "rule set \"triangles\": has no rules");
}

TEST(RuleSetRejection, OfLevelsOutOfRange) {
  for (int level : {-1, 0, 1001}) {
    RuleSetDefinition d = triangleSetDefinition();
    d.maxLevel = level;
    EXPECT_EQ(errorOf(d), "rule set \"triangles\": the quality levels must end between 1 and 1000");
  }
}

TEST(RuleSetRejection, OfMatchTolerancesThatDoNotFitTheLevels) {
  RuleSetDefinition d = triangleSetDefinition();
  d.matchTolerance.pop_back();
  EXPECT_EQ(errorOf(d), "rule set \"triangles\": needs one match tolerance for each quality level");
}

TEST(RuleSetRejection, OfMatchTolerancesThatAreNoNumbersInRange) {
  for (double bad : {-1e-9, 1e7, std::numeric_limits<double>::quiet_NaN(),
                     std::numeric_limits<double>::infinity()}) {
    RuleSetDefinition d = triangleSetDefinition();
    d.matchTolerance[7] = bad;
    EXPECT_EQ(errorOf(d),
              "rule set \"triangles\": a match tolerance is not a number between 0 and 1e6");
  }
}

TEST(RuleSetRejection, OfAMissingMetricOrOrder) {
  RuleSetDefinition d = triangleSetDefinition();
  d.metric = nullptr;
  EXPECT_EQ(errorOf(d), "rule set \"triangles\": has no element metric");
  d = triangleSetDefinition();
  d.order = nullptr;
  EXPECT_EQ(errorOf(d), "rule set \"triangles\": has no front order");
}

}  // namespace
}  // namespace af2
