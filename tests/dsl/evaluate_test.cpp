#include "dsl/evaluate.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "dsl/rule_file.h"
#include "engine/error.h"

namespace af2::dsl {
namespace {

std::shared_ptr<const RuleSet> classic() {
  const LoadedRules loaded = loadRules(AF2_SOURCE_DIR "/rules/tri/classic.af2");
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  return loaded.rules;
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
