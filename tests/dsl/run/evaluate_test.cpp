#include "dsl/run/evaluate.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "dsl/load/rule_file.h"
#include "dsl/load/shipped_rules.h"
#include "engine/base/error.h"

namespace af2::dsl {
namespace {

std::shared_ptr<const RuleSet> classic() {
  const LoadedRules loaded = loadRules(AF2_SOURCE_DIR "/rules/tri/classic.af2");
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  return loaded.rules;
}

EvalResult evaluated(const RuleSet& rules, const char* rule, int level,
                     std::map<std::string, Point2> match) {
  EvalRequest request;
  request.rule = rule;
  request.level = level;
  request.match = std::move(match);
  return evaluateRule(rules, request);
}

TEST(Evaluate, SaysWhatARuleWouldDo) {
  EvalRequest request;
  request.rule = "right 120";
  request.level = 2;
  request.match = {{"b", {1.1, 0}}, {"c", {1.5, 0.9}}};
  request.points = {{0.4, 0.9}, {3, 3}};
  request.segments = {{{-5, 0.5}, {5, 0.5}}, {{0, 0}, {1.1, 0}}};
  const EvalResult result = evaluateRule(*classic(), request);
  EXPECT_EQ(result.refused, Refusal::None);
  EXPECT_TRUE(result.matches);
  ASSERT_EQ(result.newVertices.size(), 1u);
  EXPECT_NEAR(result.newVertices[0].second->x, 0.4, 1e-12);
  EXPECT_NEAR(result.newVertices[0].second->y, 0.9, 1e-12);
  ASSERT_EQ(result.zones.size(), 1u);
  EXPECT_EQ(result.zones[0].size(), 6u);
  EXPECT_EQ(result.pointsInZone, (std::vector<bool>{true, false}));
  EXPECT_EQ(result.segmentsMeetZone, (std::vector<bool>{true, false}))
      << "the base is on the boundary";
}

TEST(Evaluate, GivesTheFirstReason) {
  EvalRequest request;
  request.rule = "2 h vis a vis";
  EXPECT_EQ(evaluateRule(*classic(), request).refused, Refusal::Class);
  request.level = 3;
  request.match["c"] = {5, 5};
  EXPECT_EQ(evaluateRule(*classic(), request).refused, Refusal::Pattern);
  request.match.clear();
  EXPECT_EQ(evaluateRule(*classic(), request).refused, Refusal::None);
}

TEST(Evaluate, GivesTheNumbersBehindAReason) {
  const LoadedRules loaded = loadRulesFromText("reasons.af2", R"(af2 1;
ruleset "s" { elements tri; match 1; accept score < 2; }
rule "corner" quality 2..4 {
  front a -> b -> c;
  at    c (0.5, 1) ~ 4;
  slope b -> c ~ (0, 0, 16);
  require c.y > 0, turn(b) < 70deg;
  zone  a, b, c;
  tri   a b c;
})");
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  const auto because = [&](int level, Point2 b, Point2 c) {
    return evaluated(*loaded.rules, "corner", level, {{"b", b}, {"c", c}}).because;
  };
  EXPECT_EQ(because(1, {1, 0}, {0.5, 1}), "level 1 is not one of the rule's, 2..4");
  EXPECT_EQ(because(2, {1, 0}, {1.5, 1}),
            "vertex c deviates by 4 from its reference; at most 1 is allowed");
  EXPECT_EQ(because(2, {1, 0}, {0.5, 1.5}),
            "the slope of b -> c deviates by 4 from its reference; at most 1 is allowed");
  EXPECT_EQ(because(2, {1, 0}, {0.9, 1}), "condition 2 does not hold");
  EXPECT_EQ(because(2, {1, 0}, {0.5, 1}), "");
  EXPECT_EQ(because(2, {9, 0}, {0.5, 1}).substr(0, 39), "the rule set does not accept a score of");
}

TEST(Evaluate, ShowsPlacesThatNearLooksAround) {
  const auto rules = shippedRules("quad/paving.af2");
  const EvalResult result = evaluated(*rules, "meet", 1, {{"c", {1.3, 1.4}}});
  ASSERT_EQ(result.acts.near.size(), 1u);
  const EvaluatedActs::Near& near = result.acts.near.front();
  EXPECT_EQ(near.vertex, "c");
  EXPECT_NEAR(near.place->x, 1, 1e-12);
  EXPECT_NEAR(near.place->y, 1, 1e-12);
  EXPECT_DOUBLE_EQ(near.reach, 0.9);
  EXPECT_NEAR(*near.away, 0.5, 1e-12);
  EXPECT_NE(toText(result).find("near c    0.5 from (1, 1), within 0.9\n"), std::string::npos)
      << toText(result);
  EXPECT_EQ(evaluated(*rules, "meet", 1, {{"c", {1.3, 2}}}).refused, Refusal::Pattern);
  EXPECT_TRUE(evaluated(*rules, "side", 1, {}).acts.near.empty());
}

TEST(Evaluate, ShowsWeldsAndPaths) {
  const auto rules = shippedRules("quad/paving.af2");
  const EvalResult seam = evaluated(*rules, "seam", 1, {{"c", {0.5, 0.2}}});
  ASSERT_TRUE(seam.acts.weld);
  EXPECT_EQ(seam.acts.weld->from, "c");
  EXPECT_EQ(seam.acts.weld->into, "a");
  EXPECT_NEAR(seam.acts.weld->place->x, 0.25, 1e-12);
  EXPECT_NE(toJson(seam).find("\"weld\""), std::string::npos);
  const EvalResult bridge = evaluated(*rules, "bridge", 8, {{"c", {3, 4}}});
  ASSERT_TRUE(bridge.acts.path);
  EXPECT_NEAR(*bridge.acts.path->segments, 5, 1e-12);
  EXPECT_EQ(toJson(bridge).find("\"weld\""), std::string::npos);
}

TEST(Evaluate, TakesCountsFromTheEnvironment) {
  const auto rules = shippedRules("quad/paving.af2");
  EvalRequest request;
  request.rule = "side";
  EXPECT_TRUE(evaluateRule(*rules, request).requireHolds);
  request.environment = {{"count(a)", 1}};
  EXPECT_FALSE(evaluateRule(*rules, request).requireHolds);
  request.rule = "seam";
  request.environment = {{"turn(b)", 20}, {"valence(b)", 2}, {"fixed(b)", 0}};
  EXPECT_FALSE(evaluateRule(*rules, request).requireHolds);
  request.environment["fixed(b)"] = 1;
  EXPECT_TRUE(evaluateRule(*rules, request).requireHolds);
}

TEST(Evaluate, GivesTheCornersOfAZoneAsWritten) {
  const LoadedRules loaded = loadRulesFromText("ell.af2", R"(af2 1;
ruleset "s" { elements tri; }
rule "ell" quality 1 {
  new  c = mid(a, b) + (0, 0.5);
  zone poly(a, b, b + (0, 1.4) => b + (0, 1), mid(a, b) + (0, 0.9), a + (0, 1.4));
  tri  a b c;
})");
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  EvalRequest request;
  request.rule = "ell";
  request.level = 2;
  const EvalResult result = evaluateRule(*loaded.rules, request);
  ASSERT_EQ(result.zones.size(), 1u);
  const std::vector<Point2> wanted{{0, 0}, {1, 0}, {1, 1.2}, {0.5, 0.9}, {0, 1.4}};
  ASSERT_EQ(result.zones[0].size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_LT(distance(result.zones[0][i], wanted[i]), 1e-15) << i;
}

TEST(Evaluate, RefusesAQuadrilateralThatIsStraightAtACornerButForRounding) {
  const LoadedRules loaded = loadRulesFromText("quad.af2", R"(af2 1;
ruleset "s" { elements quad; match 9; }
rule "quad" quality 1 { front a -> b -> c -> d -> a; at c (1, 1), d (0, 1); zone a, b, c, d; quad a b c d; }
)");
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  EvalRequest request;
  request.rule = "quad";
  for (const double beside : {0.0, 1e-16, 1e-12, 1e-6}) {
    request.match = {{"c", {1, 1}}, {"d", {0.5 - beside, 0.5 + beside}}};
    EXPECT_EQ(evaluateRule(*loaded.rules, request).refused,
              beside < 1e-9 ? Refusal::Inverted : Refusal::None)
        << beside;
  }
}

TEST(Evaluate, ExpectsVerticesWhereTheirLevelDoes) {
  const LoadedRules loaded = loadRulesFromText("places.af2", R"(af2 1;
def height(level) = if level < 4 then 1 else 0.5;
ruleset "by level" { elements tri; match 0.01; }
rule "free" quality 1 { new c = mid(a, b) + (0, 0.8); zone a, b, c; tri a b c; }
rule "corner" quality 2..9 {
  front a -> b -> c;
  at    c (0.5 + 0.1 * q, height(q));
  slope b -> c ~ 2;
  zone  a, b, c;
  tri   a b c;
  mirror "corner, left" { quality 3..9; }
})");
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  const auto at = [&](const char* rule, int level, std::map<std::string, Point2> match) {
    return evaluated(*loaded.rules, rule, level, std::move(match));
  };
  for (const int level : {2, 3, 4, 9}) {
    const Point2 c{0.5 + 0.1 * level, level < 4 ? 1 : 0.5};
    EXPECT_TRUE(at("corner", level, {{"c", c}}).matches) << level;
    EXPECT_EQ(at("corner", level, {}).zones[0][2], c) << "where nothing else is said";
    EXPECT_FALSE(at("corner", level, {{"c", {c.x + 0.099, c.y}}}).matches) << "the slope";
    EXPECT_TRUE(at("corner", level, {{"b", {1.099, 0}}, {"c", {c.x + 0.099, c.y}}}).matches);
    const bool isLater = at("corner", level + 1, {{"c", {c.x - 0.01, c.y}}}).matches;
    EXPECT_EQ(isLater, level == 9) << "the last level's place holds above it, " << level;
  }
  EXPECT_EQ(at("corner, left", 5, {}).zones[0][2], (Point2{0, 0.5}));
  EXPECT_TRUE(at("corner, left", 5, {{"c", {0.05, 0.5}}}).matches);
  EXPECT_FALSE(at("corner, left", 4, {{"c", {0, 0.5}}}).matches);
  EXPECT_EQ(at("corner, left", 2, {}).refused, Refusal::Class);
}

TEST(Evaluate, KnowsTheLevelInScoresMetricsAndTolerances) {
  const LoadedRules loaded = loadRulesFromText("levels.af2", R"(af2 1;
metric uneven(weight, u, v, w) = weight * q * (dist(u, v) / dist(v, w) - 1);
ruleset "by level" {
  elements tri;
  match    1;
  score    max of uneven(2 + q) + 0.5 / q;
  accept   score < 100;
}
rule "free" quality 1 { new c = mid(a, b) + (0, 0.8); zone a, b, c; tri a b c; }
rule "corner" quality 2 {
  front a -> b -> c;
  at    c (0.5, 1) ~ 4 / q;
  slope b -> c ~ (0, 0, 16 / q^2);
  zone  a, b, c;
  tri   a b c;
  mirror "corner, left" { at c ~ (2, 0.25 * min(q, 8), 2); quality 3; }
})");
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  const auto at = [&](const char* rule, int level, std::map<std::string, Point2> match) {
    return evaluated(*loaded.rules, rule, level, std::move(match));
  };
  // The base of length 1.2 and two sides of length 1: (2 + q) q (1.2 - 1) + 0.5 / q.
  for (const int level : {1, 2, 5})
    EXPECT_NEAR(*at("free", level, {{"b", {1.2, 0}}}).score,
                (2 + level) * level * 0.2 + 0.5 / level, 1e-12);
  // 4/q of a square of 0.5 (16/q^2 of that in y) is at most 1 from level 2 on, in both directions.
  EXPECT_FALSE(at("corner", 2, {{"c", {1.25, 1}}}).matches);
  EXPECT_TRUE(at("corner", 3, {{"c", {1.25, 1}}}).matches);
  EXPECT_FALSE(at("corner", 2, {{"c", {0.5, 1.6}}}).matches);
  EXPECT_TRUE(at("corner", 3, {{"c", {0.5, 1.6}}}).matches);
  // 2 dx2 - 0.25 q dx dy + 2 dy2 in the mirror image, with dx = dy = 0.6 and -dy.
  EXPECT_FALSE(at("corner, left", 3, {{"c", {1.1, 1.6}}}).matches);
  EXPECT_TRUE(at("corner, left", 5, {{"c", {1.1, 1.6}}}).matches);
  EXPECT_FALSE(at("corner, left", 5, {{"c", {1.1, 0.4}}}).matches);
}

TEST(Evaluate, WritesJson) {
  EvalRequest request;
  request.rule = "free triangle 1";
  const auto json = nlohmann::json::parse(toJson(evaluateRule(*classic(), request)));
  EXPECT_TRUE(json.at("refused").is_null());
  EXPECT_EQ(json.at("new").at("c"), (nlohmann::json{0.5, 0.866}));
  EXPECT_EQ(json.at("zones").at(0).size(), 5u);
  EXPECT_LT(json.at("score").get<double>(), 1e-8);
}

TEST(Evaluate, RefusesWhatThereIsNot) {
  EvalRequest request;
  request.rule = "right 12";
  EXPECT_THROW(evaluateRule(*classic(), request), InputError);
  request.rule = "right 120";
  request.match["z"] = {0, 0};
  EXPECT_THROW(evaluateRule(*classic(), request), InputError);
}

}  // namespace
}  // namespace af2::dsl
