#include "engine/step/rule_evaluation.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/support/triangle_rules.h"

namespace af2 {
namespace {

using namespace af2::testing;

class Number final : public AF2BindingFunction {
 public:
  explicit Number(std::optional<double> value) : value_(value) {}
  std::optional<double> evaluate(const AF2Binding&) const override { return value_; }

 private:
  std::optional<double> value_;
};

class InfiniteMetric final : public AF2ElementMetric {
  std::optional<double> badness(std::span<const Point2>) const override { return INFINITY; }
};

RuleEvaluation evaluated(const RuleDefinition& definition, std::vector<Point2> vertices,
                         int level = 1,
                         const std::function<void(RuleSetDefinition&)>& change = {}) {
  RuleSetDefinition set = triangleSetDefinition();
  set.rules = {AF2Rule(definition)};
  if (change) change(set);
  const RuleSet rules(set);
  const RuleAtMatch match(rules.rules()[0].definition(), std::move(vertices), level);
  return evaluateMatch(rules, rules.rules()[0], match.binding());
}

std::vector<Point2> reference(const RuleDefinition& rule) {
  return RuleAtMatch::atReference(rule, rule.firstLevel).vertices();
}

TEST(RuleEvaluation, GivesTheNumbersOfAMisfit) {
  const RuleDefinition rule = right60().definition();
  const RefusalCause cause = evaluated(rule, {{0, 0}, {1, 0}, {2.5, 0.866}}).refused;
  EXPECT_EQ(cause.reason, Refusal::Pattern);
  EXPECT_EQ(cause.index, 2);
  EXPECT_FALSE(cause.isEdge);
  EXPECT_DOUBLE_EQ(cause.value, 0.6 * 4);
  EXPECT_DOUBLE_EQ(cause.limit, 0.8);
}

TEST(RuleEvaluation, GivesTheEdgeWhoseSlopeMisfits) {
  RuleDefinition rule = right60().definition();
  rule.edges[1].slope = ToleranceForm{4, 0, 0};
  const RefusalCause cause = evaluated(rule, {{0, 0}, {1, 0}, {1, 0.866}}).refused;
  EXPECT_EQ(cause.reason, Refusal::Pattern);
  EXPECT_EQ(cause.index, 1);
  EXPECT_TRUE(cause.isEdge);
  EXPECT_DOUBLE_EQ(cause.value, 1);
}

TEST(RuleEvaluation, GivesTheConditionThatFails) {
  RuleDefinition rule = right60().definition();
  rule.requirements = {std::make_shared<Number>(1), std::make_shared<Number>(0)};
  EXPECT_EQ(evaluated(rule, reference(rule)).refused.reason, Refusal::Require);
  EXPECT_EQ(evaluated(rule, reference(rule)).refused.index, 1);
  rule.requirements = {std::make_shared<Number>(std::nullopt)};
  EXPECT_EQ(evaluated(rule, reference(rule)).refused.reason, Refusal::NoValue);
}

TEST(RuleEvaluation, GivesTheElementThatIsInverted) {
  RuleDefinition rule = right120().definition();
  rule.newVertices = {combine({1.2, 0.1}, {})};  // to the right of b -> c
  const RefusalCause cause = evaluated(rule, reference(rule)).refused;
  EXPECT_EQ(cause.reason, Refusal::Inverted);
  EXPECT_EQ(cause.index, 1);
}

TEST(RuleEvaluation, AnswersWhatARefusalDoesNotHide) {
  RuleDefinition rule = right120().definition();
  rule.firstLevel = 3;
  const RuleEvaluation evaluation = evaluated(rule, {{0, 0}, {1, 0}, {9, 0.866}});
  EXPECT_EQ(evaluation.refused.reason, Refusal::Class);
  EXPECT_EQ(evaluation.misfit.reason, Refusal::Pattern);
  EXPECT_TRUE(evaluation.required.isNone());
  EXPECT_EQ(evaluation.newVertices.at(0), (Point2{8, 0.866}));
}

TEST(RuleEvaluation, HasNoScoreWhereANumberIsNotFinite) {
  RuleDefinition rule = right60().definition();
  const auto change = [](RuleSetDefinition& set) {
    set.metric = std::make_shared<InfiniteMetric>();
  };
  const RuleEvaluation infinite = evaluated(rule, reference(rule), 1, change);
  EXPECT_EQ(infinite.refused.reason, Refusal::NoValue);
  EXPECT_FALSE(infinite.score);
  for (const std::optional<double> cost :
       {std::optional(double{INFINITY}), std::optional<double>()}) {
    rule.cost = std::make_shared<Number>(cost);
    EXPECT_EQ(evaluated(rule, reference(rule)).refused.reason, Refusal::NoValue);
  }
}

TEST(RuleEvaluation, GivesAScoreThatIsNotAccepted) {
  RuleDefinition rule = right60().definition();
  rule.cost = std::make_shared<Number>(7);
  const RuleEvaluation evaluation = evaluated(rule, reference(rule));
  EXPECT_EQ(evaluation.refused.reason, Refusal::Score);
  EXPECT_NEAR(*evaluation.score, 7, 1e-6);
}

}  // namespace
}  // namespace af2
