// What is said about a rule without a front is what the front does.
#include "engine/step/rule_evaluation.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "dsl/load/rule_file.h"
#include "dsl/match/given_match.h"
#include "dsl/match/match_sampler.h"
#include "dsl/run/evaluate.h"
#include "engine/base/error.h"

namespace af2::dsl {
namespace {

/// Asks for all that a rule can ask about its surroundings.
constexpr const char* kAsking = R"(af2 1;
ruleset "asking" { elements tri, quad; match 1 + 0.1 * q; score sum of shape_size(2); accept score < 3 * q; }
rule "turning" quality 1 {
  front   z -> a -> b -> c;
  at      z (-0.5, 0.9) ~ 2, c (1.5, 0.9) ~ (2, 0.5, 1);
  slope   b -> c ~ (0.5, 0, 3);
  require turn(b) < 170deg and turn(a) > 50deg, loop_size() == 4;
  require dist_front(mid(z, c)) > 0.5 and dist_front(mid(a, b)) < 1e-12;
  new     d = b + rot(c - b, turn(b) / 2);
  zone    hull(a, b, c, d);
  tri     a b d, b c d;
  cost    0.1 * h(d) + 0.01 * loop_size() + 0.2 * dist_front(d) + curvature(a) + layer(c) + valence(c);
}
rule "root" quality 2..9 {
  front a -> b -> c;
  at    c (1, 1) ~ 0.7;
  new   d = a + (0, sqrt(c.y - 0.6));
  zone  a, b, c, d => mid(a, c);
  quad  a b c d;
}
rule "closed" quality 1 {
  front a -> b -> c -> d -> a;
  at    c (1, 1), d (0, 1);
  require loop_size() == 4 and on_boundary(c);
  zone  hull(a, b, c, d);
  quad  a b c d;
}
)";
constexpr const char* kScaled = R"(af2 1;
ruleset "scaled" { elements tri; match 1; scale base; }
rule "corner" quality 1 { front a -> b -> c; at c (0.5, 0.866) ~ 3; slope b -> c ~ (6, 0, 1); zone a, b, c; tri a b c; }
)";

std::shared_ptr<const RuleSet> rulesOf(const LoadedRules& loaded) {
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  return loaded.rules;
}

std::vector<std::shared_ptr<const RuleSet>> ruleSets() {
  std::vector<std::shared_ptr<const RuleSet>> sets;
  for (const char* file : {"tri/classic", "tri/even", "quad/classic", "quad/rows"})
    sets.push_back(rulesOf(loadRules(std::string(AF2_SOURCE_DIR "/rules/") + file + ".af2")));
  sets.push_back(rulesOf(loadRulesFromText("asking.af2", kAsking)));
  sets.push_back(rulesOf(loadRulesFromText("scaled.af2", kScaled)));
  return sets;
}

RuleSet onlyRule(const RuleSet& rules, const AF2Rule& rule) {
  RuleSetDefinition definition = rules.definition();
  definition.rules = {rule};
  return RuleSet(std::move(definition));
}

/// Positions that the rule accepts, and some that it does not.
std::vector<Point2> randomPositions(const RuleSet& rules, const AF2Rule& rule, int level,
                                    RandomNumbers& random) {
  const bool isScaled = rules.definition().unit == ChartUnit::BaseLength;
  std::vector<Point2> positions{{0, 0}, {isScaled ? 1 : random.between(0.5, 2), 0}};
  const double reach = random.between(0, 1.5);
  for (std::size_t i = 2; i < rule.definition().vertices.size(); ++i)
    positions.push_back(rule.definition().vertices[i].reference.at(level) +
                        reach * random.inDisc());
  return positions;
}

/// Steps of a front may match a pattern in several ways where parts of it may be anywhere.
bool isOneChain(const RuleDefinition& rule) {
  const auto chains = chainsOf(rule);
  return chains.size() == 1 &&
         chains[0].size() - (chains[0].front() == chains[0].back()) == rule.vertices.size();
}

/// Where positions are so wild that edges of the pattern fold back, new elements may lie on the
/// wrong side of the front. Only a front knows its sides: an evaluation does not.
bool isOnWrongSide(const RuleEvaluation& evaluation, const SingleStep& step) {
  return !step.rule && evaluation.refused.isNone() &&
         step.refusals.at(0).reason == Refusal::Inverted;
}

void expectSameAnswer(const RuleEvaluation& evaluation, const SingleStep& step) {
  if (!step.rule) {
    EXPECT_STREQ(toString(evaluation.refused.reason), toString(step.refusals.at(0).reason));
    return;
  }
  EXPECT_STREQ(toString(evaluation.refused.reason), "none");
  EXPECT_NEAR(evaluation.score.value_or(INFINITY), step.score,
              1e-9 * std::max(1.0, std::abs(step.score)));
  ASSERT_EQ(evaluation.newVertices.size(), step.newVertices.size());
  for (std::size_t i = 0; i < step.newVertices.size(); ++i)
    EXPECT_LT(distance(*evaluation.newVertices[i], step.newVertices[i]), 1e-12);
}

TEST(RuleEvaluation, SaysWhatTheFrontDoes) {
  constexpr int kMatches = 150;
  std::map<std::string, int> answers;
  RandomNumbers random(17);
  for (const auto& set : ruleSets())
    for (const AF2Rule& rule : set->rules()) {
      if (!isOneChain(rule.definition())) continue;
      const RuleSet rules = onlyRule(*set, rule);
      SingleStepper stepper(rules);
      for (int i = 0; i < kMatches; ++i) {
        const int level = 1 + static_cast<int>(random.between(0, 12));
        const PatternMatch match(rule, randomPositions(rules, rule, level, random), level);
        const RuleEvaluation evaluation = evaluateMatch(rules, rule, match.binding());
        const SingleStep step = stepper.take(pieceOf(match, level));
        SCOPED_TRACE(rules.name() + ": " + rule.name() + " at level " + std::to_string(level));
        if (isOnWrongSide(evaluation, step)) {
          ++answers["on the wrong side"];
          continue;
        }
        expectSameAnswer(evaluation, step);
        if (HasFailure()) return;
        ++answers[toString(evaluation.refused.reason)];

        EvalRequest request;
        request.rule = rule.name();
        request.level = level;
        for (std::size_t v = 0; v < match.vertices().size(); ++v)
          request.match[rule.definition().vertices[v].name] = match.vertices()[v];
        const EvalResult result = evaluateRule(rules, request);
        EXPECT_EQ(result.refused, evaluation.refused.reason);
        EXPECT_EQ(result.score, evaluation.score);
        EXPECT_EQ(match.refusalOfMatch(rules) == Refusal::None,
                  rule.appliesAt(level) && result.matches && result.requireHolds);
      }
    }
  for (const char* reason :
       {"none", "class", "pattern", "require", "novalue", "convexity", "inverted", "score"})
    EXPECT_GT(answers[reason], 4) << reason << " is hardly tried";
  EXPECT_LT(answers["on the wrong side"], answers["none"] / 20);
}

TEST(RuleEvaluation, AgreesWithTheFrontOnWhatIsSampled) {
  for (const auto& set : ruleSets())
    for (const AF2Rule& rule : set->rules()) {
      const RuleSet rules = onlyRule(*set, rule);
      const int level = rule.definition().firstLevel;
      SingleStepper stepper(rules);
      MatchSampler sampler(rules, rule, level);
      for (int i = 0; i < 20; ++i) {
        const auto match = sampler.next();
        if (!match) break;
        const SingleStep step = stepper.take(pieceOf(*match, level));
        if (step.rule) continue;
        EXPECT_GT(step.refusals.at(0).reason, Refusal::Require) << rule.name();
      }
    }
}

TEST(RuleEvaluation, SurroundsAMatchByTheEdgesOfItsPattern) {
  const auto rules = rulesOf(loadRulesFromText("asking.af2", kAsking));
  const RuleDefinition& rule = rules->rules()[0].definition();
  const RuleAtMatch match(rule, {{0, 0}, {1, 0}, {0, 1}, {1, 1}}, 1);
  EXPECT_EQ(match.loopSize(), 4);
  EXPECT_DOUBLE_EQ(match.distanceToFront({0.5, 0.75}), 0.5);
  EXPECT_DOUBLE_EQ(match.distanceToFront({-3, -4}), 5);
  EXPECT_NEAR(*match.turn(0), M_PI / 2, 1e-15);
  EXPECT_FALSE(match.turn(2));
  EXPECT_TRUE(match.onBoundary(2));
  const GivenMatch given(rule, match.vertices(), 1, {{"layer(c)", 2}, {"dist_front", 7}});
  EXPECT_EQ(given.loopSize(), 4);
  EXPECT_EQ(given.distanceToFront({0, 0}), 7);
  EXPECT_FALSE(given.onBoundary(3)) << "two layers of elements lie between";
  EXPECT_TRUE(given.onBoundary(2));
}

}  // namespace
}  // namespace af2::dsl
