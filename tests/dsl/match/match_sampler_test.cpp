#include "dsl/match/match_sampler.h"

#include <gtest/gtest.h>

#include "../proof/quad_rules.h"

namespace af2::dsl {
namespace {

TEST(MatchSampler, DrawsOnlyWhatThePatternAccepts) {
  const RuleSet rules = testing::quadSet();
  for (const AF2Rule& rule : rules.rules()) {
    const int level = rule.definition().firstLevel;
    MatchSampler sampler(rules, rule, level);
    for (int i = 0; i < 200; ++i) {
      const auto match = sampler.next();
      ASSERT_TRUE(match);
      EXPECT_EQ(match->refusalOfMatch(rules), Refusal::None);
    }
  }
}

TEST(MatchSampler, ReachesTheRimOfATiltedTolerance) {
  RuleDefinition definition = testing::right60().definition();
  definition.vertices[2].tolerance = ToleranceForm{1, 1.2, 2};
  const AF2Rule rule(definition);
  const auto rules = testing::triangleSet();
  MatchSampler sampler(*rules, rule, 1);
  double largest = 0, mean = 0;
  constexpr int kCount = 2000;
  for (int i = 0; i < kCount; ++i) {
    const Point2 d = sampler.next()->vertices()[2] - rule.definition().vertices[2].reference.at(1);
    const double w = rule.definition().vertices[2].tolerance->at(1)(d) / rules->matchTolerance(1);
    largest = std::max(largest, w);
    mean += w / kCount;
  }
  EXPECT_GT(largest, 0.99);
  EXPECT_NEAR(mean, 0.5, 0.03);  // uniform in the ellipse
}

TEST(MatchSampler, GivesUpOnWhatNeverHolds) {
  class Never final : public AF2BindingFunction {
    std::optional<double> evaluate(const AF2Binding&) const override { return 0; }
  };
  RuleDefinition definition = testing::right60().definition();
  definition.requirements = {std::make_shared<Never>()};
  const AF2Rule rule(definition);
  const auto rules = testing::triangleSet();
  EXPECT_FALSE(MatchSampler(*rules, rule, 1).next());
}

TEST(PatternMatch, KnowsTheFreeAngles) {
  const AF2Rule rule = testing::fillQuad();
  const PatternMatch match(rule, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  EXPECT_NEAR(*match.turn(1), M_PI / 2, 1e-15);
  const AF2Rule open = testing::right120();
  const PatternMatch bend(open, {{0, 0}, {1, 0}, {1.5, 0.866}}, 1);
  EXPECT_NEAR(*bend.turn(1), 2 * M_PI / 3, 1e-4);
  EXPECT_EQ(bend.turn(0), std::nullopt);
}

}  // namespace
}  // namespace af2::dsl
