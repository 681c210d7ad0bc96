#include "dsl/checks/proof.h"

#include <gtest/gtest.h>

#include "dsl/checks/affine_form.h"
#include "quad_rules.h"

namespace af2::dsl {
namespace {

/// A new corner straight above a, at the height of c: not a combination of zone corners.
AF2Rule quadRight(double overhang) {
  RuleDefinition rule =
      testing::ruleWith("quad right", 1, {{"c", {1, 1}, ToleranceForm{4, 0, 4}}}, {{0, 1}, {1, 2}});
  rule.newVertexNames = {"d"};
  rule.newVertices = {std::make_shared<AffinePointTransform>(
      Point2{}, std::vector<AffinePointTransform::Term>{{2, 0, 0, 0, 1}})};
  rule.zone = testing::zone(
      {testing::at(0),
       testing::at(1),
       testing::at(2),
       {std::make_shared<AffinePointTransform>(
           Point2{-overhang, 0}, std::vector<AffinePointTransform::Term>{{2, 0, 0, 0, 1.5}})}});
  rule.elements = {testing::quad(0, 1, 2, 3)};
  return AF2Rule(rule);
}

RuleSet setOf(AF2Rule rule) {
  RuleSetDefinition set = testing::triangleSetDefinition();
  set.rules = {std::move(rule)};
  return RuleSet(std::move(set));
}

bool positive(const AF2Rule& rule) { return provesPositive(setOf(rule), rule, 1); }
bool covered(const AF2Rule& rule) { return provesCovered(setOf(rule), rule, 1); }

TEST(Proof, CutsTheToleranceIntoBoxesWhereCombinationsDoNotDo) {
  EXPECT_TRUE(positive(quadRight(0.5)));
  EXPECT_TRUE(covered(quadRight(0.5)));
}

TEST(Proof, DoesNotProveWhatIsFalse) {
  EXPECT_FALSE(covered(quadRight(-0.2)));  // the zone ends to the right of d
  EXPECT_FALSE(covered(testing::quadPRight150()));
}

TEST(Proof, IsOnlyForAffineRules) {
  RuleDefinition rule = testing::freeTriangle().definition();
  class NoZone final : public AF2FreeZoneDef {
    Made makeFreeZone(const AF2Binding&) const override { return {}; }
  };
  rule.zone = std::make_shared<NoZone>();
  EXPECT_FALSE(positive(AF2Rule(rule)));
}

FormPoint at(double x, double y) { return {{x}, {y}}; }

TEST(ConvexCombinations, AreFoundForPointsInside) {
  const std::vector<FormPoint> square{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
  EXPECT_EQ(convexCombinations(at(1, 1), square), (std::vector<Weights>{{0, 0, 1, 0}}));
  EXPECT_FALSE(convexCombinations(at(0.3, 0.6), square).empty());
  EXPECT_TRUE(convexCombinations(at(1.1, 0.6), square).empty());
}

TEST(NeverTurnRight, HoldsForCornersInOrder) {
  const std::vector<FormPoint> square{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
  EXPECT_TRUE(neverTurnRight(square[0], square[1], square[3], square));
  EXPECT_TRUE(neverTurnRight(square[3], square[0], square[2], square));
  EXPECT_FALSE(neverTurnRight(square[0], square[3], square[1], square));
  EXPECT_TRUE(neverTurnRight(square[0], square[1], at(0.5, 0.5), square));
  EXPECT_FALSE(neverTurnRight(square[0], square[2], at(0.5, 0.5), square));
}

}  // namespace
}  // namespace af2::dsl
