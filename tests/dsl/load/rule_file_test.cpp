#include "dsl/load/rule_file.h"

#include <gtest/gtest.h>

#include <random>

namespace af2::dsl {
namespace {

/// The twelve triangle rules as published numbers: weights of the matched vertices in each new
/// point and zone corner, and a constant.
struct PublishedPoint {
  Point2 constant;
  std::vector<double> weights;
};

struct PublishedRule {
  const char* name;
  std::vector<Point2> references;
  std::vector<PublishedPoint> newPoints, preferred, limiting;
};

using Points = std::vector<PublishedPoint>;

std::vector<PublishedRule> publishedRules() {
  const PublishedPoint a{{}, {1}}, b{{}, {0, 1}}, c{{}, {0, 0, 1}}, d{{}, {0, 0, 0, 1}};
  const PublishedPoint apex{{0, 0.866}, {0.5, 0.5}};
  const auto flat = [](double h) { return PublishedPoint{{0, h}, {0.5, 0.5}}; };
  const auto above = [](double h, bool right) {
    return PublishedPoint{{0, h}, right ? std::vector<double>{0, 1} : std::vector<double>{1}};
  };
  const Point2 A{0, 0}, B{1, 0};
  std::vector<PublishedRule> rules;
  rules.push_back({"free triangle 1",
                   {A, B},
                   {apex},
                   {a, b, {{1, 0.7}, {0.5, 0.5}}, {{0, 1.5}, {0.5, 0.5}}, {{-1, 0.7}, {0.5, 0.5}}},
                   {a, b, apex, apex, apex}});
  for (const auto& [name, h, z] : {std::tuple("free triangle 5", 0.5, 0.7),
                                   {"free triangle 10", 0.3, 0.5},
                                   {"free triangle 20", 0.1, 0.2}})
    rules.push_back({name,
                     {A, B},
                     {flat(h)},
                     {a, b, above(z, true), above(z, false)},
                     {a, b, flat(h), flat(h)}});
  rules.push_back({"right 60",
                   {A, B, {0.5, 0.866}},
                   {},
                   {a, b, c, {{}, {0.75, -0.5, 0.75}}},
                   {a, b, c, {{}, {0.5, 0, 0.5}}}});
  rules.push_back({"left 60",
                   {A, B, {0.5, 0.866}},
                   {},
                   {a, b, {{}, {-0.5, 0.75, 0.75}}, c},
                   {a, b, {{}, {0, 0.5, 0.5}}, c}});
  rules.push_back({"right 120",
                   {A, B, {1.5, 0.866}},
                   {{{}, {1, -1, 1}}},
                   {a, b, c, {{}, {1, -2, 2}}, {{}, {2, -3, 2}}, {{}, {2, -2, 1}}},
                   {}});
  rules.push_back({"left 120",
                   {A, B, {-0.5, 0.866}},
                   {{{}, {-1, 1, 1}}},
                   {a, b, {{}, {-2, 2, 1}}, {{}, {-3, 2, 2}}, {{}, {-2, 1, 2}}, c},
                   {}});
  rules.push_back({"left right 120",
                   {A, B, {-0.5, 0.866}, {1.5, 0.866}},
                   {{{}, {0, 0, 0.5, 0.5}}},
                   {a, b, d, {{}, {0, -0.5, 0.375, 1.125}}, {{}, {-0.5, 0, 1.125, 0.375}}, c},
                   {}});
  rules.push_back({"fill triangle", {A, B, {0.5, 0.866}}, {}, {a, b, c}, {}});
  rules.push_back({"vis a vis",
                   {A, B, {0.5, 0.866}},
                   {},
                   {a, b, {{}, {-0.6, 0.8, 0.8}}, c, {{}, {0.8, -0.6, 0.8}}},
                   {a, b, {{}, {0, 0.5, 0.5}}, c, {{}, {0.5, 0, 0.5}}}});
  rules.push_back({"2 h vis a vis",
                   {A, B, {1, 1.732}, {0, 1.732}},
                   {{{}, {0.25, 0.25, 0.25, 0.25}}},
                   {a, b, {{}, {-0.25, 0.75, 0.75, -0.25}}, c, d, {{}, {0.75, -0.25, -0.25, 0.75}}},
                   {}});
  return rules;
}

Point2 placed(const PublishedPoint& p, const std::vector<Point2>& matched) {
  Point2 result = p.constant;
  for (std::size_t i = 0; i < p.weights.size(); ++i) result = result + p.weights[i] * matched[i];
  return result;
}

LoadedRules classic() { return loadRules(AF2_SOURCE_DIR "/rules/tri/classic.af2"); }

void expectNear(Point2 actual, Point2 expected, const std::string& what) {
  EXPECT_NEAR(actual.x, expected.x, 1e-12) << what;
  EXPECT_NEAR(actual.y, expected.y, 1e-12) << what;
}

TEST(ClassicTriangles, PlaceVerticesAndZonesAsPublished) {
  const LoadedRules loaded = classic();
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  const auto published = publishedRules();
  ASSERT_EQ(loaded.rules->rules().size(), published.size());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> deviation(-0.4, 0.4);
  for (std::size_t r = 0; r < published.size(); ++r) {
    const RuleDefinition& rule = loaded.rules->rules()[r].definition();
    const PublishedRule& expected = published[r];
    EXPECT_EQ(rule.name, expected.name);
    ASSERT_EQ(rule.vertices.size(), expected.references.size());
    for (std::size_t i = 0; i < rule.vertices.size(); ++i)
      EXPECT_EQ(rule.vertices[i].reference, expected.references[i]);
    for (int sample = 0; sample < 20; ++sample) {
      std::vector<Point2> matched = expected.references;
      matched[1].x += deviation(random);
      for (std::size_t i = 2; i < matched.size(); ++i)
        matched[i] = matched[i] + Point2{deviation(random), deviation(random)};
      const AF2Binding binding{matched, 3, nullptr};
      ASSERT_EQ(rule.newVertices.size(), expected.newPoints.size());
      for (std::size_t i = 0; i < rule.newVertices.size(); ++i)
        expectNear(rule.newVertices[i]->transformPoint(binding).value(),
                   placed(expected.newPoints[i], matched), rule.name);
      const auto* zone = dynamic_cast<const ConvexPolygonZoneDef*>(rule.zone.get());
      ASSERT_NE(zone, nullptr) << "the fast form";
      ASSERT_EQ(zone->corners().size(), expected.preferred.size());
      const Points& limiting = expected.limiting.empty() ? expected.preferred : expected.limiting;
      for (std::size_t i = 0; i < limiting.size(); ++i) {
        const auto& corner = zone->corners()[i];
        const auto& limit = corner.limiting ? corner.limiting : corner.preferred;
        expectNear(corner.preferred->transformPoint(binding).value(),
                   placed(expected.preferred[i], matched), rule.name);
        expectNear(limit->transformPoint(binding).value(), placed(limiting[i], matched), rule.name);
      }
    }
  }
}

TEST(Libraries, NeedNoRuleSetUnlessTheyAreRun) {
  const std::string definitions = "af2 1;\nconst H = sqrt(3)/2;\ndef up(p) = p + (0, H);\n";
  const std::string withRule =
      definitions +
      "rule \"free\" quality 1 { new c = up(mid(a, b)); zone a, b, c; tri a b c; }\n"
      "test \"t\" { front p (0, 0) -> r (1, 0); expect rule \"free\"; }\n";
  LoadOptions library;
  library.needsRuleSet = false;
  for (const std::string& text : {definitions, withRule}) {
    const LoadedRules run = loadRulesFromText("lib.af2", text);
    ASSERT_EQ(run.diagnostics.size(), 1u) << toPretty(run.diagnostics);
    EXPECT_EQ(idOf(run.diagnostics[0].code), "R5");
    EXPECT_FALSE(hasErrors(loadRulesFromText("lib.af2", text, library).diagnostics));
  }
  const auto warnings = loadRulesFromText("lib.af2", withRule, library).diagnostics;
  ASSERT_EQ(warnings.size(), 1u) << "perhaps the rule set was forgotten";
  EXPECT_EQ(idOf(warnings[0].code), "R5");
  EXPECT_TRUE(loadRulesFromText("lib.af2", definitions, library).diagnostics.empty());
  EXPECT_FALSE(loadRulesFromText("lib.af2", definitions, library).rules);
  const LoadedRules loaded = loadRulesFromText("lib.af2", withRule, library);
  ASSERT_TRUE(loaded.rules);
  EXPECT_EQ(loaded.rules->maxLevel(), 50) << "the settings are the default ones";
  EXPECT_EQ(loadRulesFromText("lib.af2", definitions + "const H = 1;", library).diagnostics.size(),
            1u)
      << "everything else is told";
  const LoadedRules begun = loadRulesFromText("begun.af2", "af2 1;\nruleset \"s\" {}\n", library);
  ASSERT_EQ(begun.diagnostics.size(), 1u) << "a rule set is there to be run";
  EXPECT_EQ(idOf(begun.diagnostics[0].code), "R5");
}

TEST(RuleSets, MayListPolyForElementsOfAnyKind) {
  const std::string rules = R"(
rule "tri" quality 1 { new c = mid(a, b) + (0, 1); zone a, b, c; poly a b c; }
rule "quad" quality 1 { new c = b + (0, 1), d = a + (0, 1); zone a, b, c, d; poly a b c d; })";
  const LoadedRules loaded =
      loadRulesFromText("p.af2", "af2 1; ruleset \"p\" { elements poly; }" + rules);
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  EXPECT_TRUE(loaded.rules->makesTriangles() && loaded.rules->makesQuads());
}

TEST(ClassicTriangles, KeepToAffineForms) {
  const LoadedRules loaded = classic();
  ASSERT_TRUE(loaded.rules);
  for (const AF2Rule& rule : loaded.rules->rules())
    for (const auto& transform : rule.definition().newVertices)
      EXPECT_NE(dynamic_cast<const AffinePointTransform*>(transform.get()), nullptr) << rule.name();
}

TEST(ClassicTriangles, ShareWhatTheClassicalSetShares) {
  const LoadedRules loaded = classic();
  ASSERT_TRUE(loaded.rules);
  const RuleSetDefinition& set = loaded.rules->definition();
  EXPECT_EQ(set.maxLevel, 50);
  EXPECT_DOUBLE_EQ(set.matchTolerance[0], 0.8);
  EXPECT_DOUBLE_EQ(set.matchTolerance[4], 2.0);
  EXPECT_NE(dynamic_cast<const ShapeSizeMetric*>(set.metric.get()), nullptr);
  EXPECT_NE(dynamic_cast<const LayeredFrontOrder*>(set.order.get()), nullptr);
  EXPECT_TRUE(set.acceptance->accepts(2.49, 1));
  EXPECT_FALSE(set.acceptance->accepts(2.5, 1));
  const auto& right60 = loaded.rules->rules()[4].definition();
  EXPECT_EQ(right60.vertices[2].tolerance, (ToleranceForm{0.6, 0, 0.8}));
  EXPECT_EQ(loaded.rules->rules()[5].definition().vertices[2].tolerance, ToleranceForm{});
}

}  // namespace
}  // namespace af2::dsl
