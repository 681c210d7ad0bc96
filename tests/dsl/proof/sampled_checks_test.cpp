#include "dsl/proof/sampled_checks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dsl/shapes/shape.h"
#include "engine/step/single_step.h"
#include "quad_rules.h"

namespace af2::dsl {
namespace {

const SampledResult& ofTriangles() {
  static const SampledResult result = runSampledChecks(*testing::triangleSet());
  return result;
}

const SampledResult& ofQuads() {
  static const SampledResult result = runSampledChecks(testing::quadSet());
  return result;
}

/// The classical triangles with one rule changed or added.
SampledResult withRule(AF2Rule rule, const SamplingOptions& options = {}) {
  RuleSetDefinition set = testing::triangleSetDefinition();
  set.rules.insert(set.rules.begin(), std::move(rule));
  SampledResult result = runSampledChecks(RuleSet(std::move(set)), options);
  std::erase_if(result.findings, [](const SampledFinding& f) { return f.rule != 0; });
  return result;
}

const SampledFinding* find(const SampledResult& result, const std::string& code, std::size_t rule) {
  for (const SampledFinding& finding : result.findings)
    if (idOf(finding.code) == code && finding.rule == rule) return &finding;
  return nullptr;
}

TEST(SampledChecks, FindNothingWrongWithTheClassicalTrianglesButLostMatches) {
  ASSERT_EQ(ofTriangles().findings.size(), 1u);
  const SampledFinding& finding = ofTriangles().findings[0];
  EXPECT_EQ(idOf(finding.code), "Z2");
  EXPECT_EQ(finding.rule, 11u);
  EXPECT_NEAR(ofTriangles().answers[11].lostMatches, 0.30, 0.03);
  EXPECT_EQ(finding.severity, Severity::Warning);
}

TEST(SampledChecks, ProveAllClassicalTriangles) {
  for (const RuleAnswers& answers : ofTriangles().answers) {
    EXPECT_EQ(answers.positive, Answer::Proven);
    EXPECT_EQ(answers.covered, Answer::Proven);
  }
}

TEST(SampledChecks, FindTheTrapezoidRuleOfTheClassicalQuads) {
  const SampledFinding* inverted = find(ofQuads(), "G2", 0);
  const SampledFinding* uncovered = find(ofQuads(), "Z1", 0);
  ASSERT_TRUE(inverted && uncovered);
  EXPECT_EQ(inverted->severity, Severity::Error);
  EXPECT_EQ(uncovered->severity, Severity::Error);
  EXPECT_NE(uncovered->message.find("extends beyond the free zone at 8"), std::string::npos)
      << uncovered->message;
  EXPECT_EQ(ofQuads().answers[0].positive, Answer::Refuted);
  EXPECT_EQ(ofQuads().answers[0].covered, Answer::Refuted);
}

TEST(SampledChecks, FindWhatTheClassicalQuadsLose) {
  EXPECT_NEAR(ofQuads().answers[1].lostMatches, 0.26, 0.03);  // two right
  EXPECT_NEAR(ofQuads().answers[2].lostMatches, 0.26, 0.03);  // left right
  EXPECT_NEAR(ofQuads().answers[3].lostMatches, 0.24, 0.03);  // right 60
  for (const std::size_t rule : {1u, 2u, 3u}) EXPECT_TRUE(find(ofQuads(), "Z2", rule));
  EXPECT_FALSE(find(ofQuads(), "Z2", 4));  // fill quad: less than a fifth
}

TEST(SampledChecks, ProveTheQuadsThatAreRight) {
  for (const std::size_t rule : {1u, 2u, 3u, 4u}) {
    EXPECT_EQ(ofQuads().answers[rule].positive, Answer::Proven);
    EXPECT_EQ(ofQuads().answers[rule].covered, Answer::Proven);
  }
}

TEST(SampledChecks, FindElementsThatTurnOver) {
  RuleDefinition rule =
      testing::ruleWith("bent", 1, {{"c", {1, 1}}, {"d", {0, 1}}}, {{0, 1}, {1, 2}, {3, 0}});
  // A zone that is convex whatever c and d do.
  rule.zone = testing::zone({{testing::combine({-9, -9}, {})},
                             {testing::combine({9, -9}, {})},
                             {testing::combine({9, 9}, {})},
                             {testing::combine({-9, 9}, {})}});
  rule.elements = {testing::quad(0, 1, 2, 3)};
  const SampledResult result = withRule(AF2Rule(rule));
  const SampledFinding* finding = find(result, "G2", 0);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->element, 0);
  ASSERT_EQ(finding->example.marks.size(), 1u);
  EXPECT_EQ(result.answers[0].positive, Answer::Refuted);
  EXPECT_FALSE(find(result, "Z1", 0));
  EXPECT_EQ(result.answers[0].covered, Answer::Proven);
}

TEST(SampledChecks, FindZonesThatDoNotCoverTheElement) {
  RuleDefinition rule = testing::freeTriangle().definition();
  rule.name = "short zone";
  rule.zone = testing::zone({testing::at(0),
                             testing::at(1),
                             {testing::combine({0.3, .6}, {{1, .5}})},
                             {testing::combine({-0.3, .6}, {{1, .5}})}});
  const SampledResult result = withRule(AF2Rule(rule));
  const SampledFinding* finding = find(result, "Z1", 0);
  ASSERT_TRUE(finding);
  EXPECT_NE(finding->message.find("at 100 %"), std::string::npos) << finding->message;
  // The test's obstacle is where the engine does not see it.
  ASSERT_EQ(finding->example.obstacles.size(), 1u);
  EXPECT_NE(finding->test.find("because zone hit by vertex o or class;"), std::string::npos);
}

TEST(SampledChecks, SeeWhatPokesOutOfARoundZone) {
  class DiscZoneDef final : public AF2FreeZoneDef {
   public:
    explicit DiscZoneDef(double radius) : radius_(radius) {}
    Made makeFreeZone(const AF2Binding& match) const override {
      MadeZone made = makeZone(Shape::disc(0.5 * match.vertices[1] + Point2{0, 0.3}, radius_));
      return {std::move(made.zone), made.refusal};
    }

   private:
    double radius_;
  };
  RuleDefinition rule = testing::freeTriangle().definition();
  rule.name = "round";
  rule.zone = std::make_shared<DiscZoneDef>(1.2);
  const SampledResult wide = withRule(AF2Rule(rule));
  EXPECT_FALSE(find(wide, "Z1", 0));
  EXPECT_EQ(wide.answers[0].covered, Answer::Sampled);
  rule.zone = std::make_shared<DiscZoneDef>(0.6);
  EXPECT_TRUE(find(withRule(AF2Rule(rule)), "Z1", 0));
}

TEST(SampledChecks, FindZonesThatGrow) {
  RuleDefinition rule = testing::freeTriangle().definition();
  rule.name = "growing";
  std::vector<ConvexPolygonZoneDef::Corner> corners;
  const auto* zone = dynamic_cast<const ConvexPolygonZoneDef*>(rule.zone.get());
  for (const auto& corner : zone->corners())
    corners.push_back(
        corner.limiting ? ConvexPolygonZoneDef::Corner{corner.limiting, corner.preferred} : corner);
  rule.zone = testing::zone(corners);
  const SampledFinding* finding = nullptr;
  const SampledResult result = withRule(AF2Rule(rule));
  finding = find(result, "Z3", 0);
  ASSERT_TRUE(finding);
  EXPECT_GT(finding->example.level, 1);
}

class ConstantCost final : public AF2BindingFunction {
 public:
  explicit ConstantCost(double value) : value_(value) {}
  std::optional<double> evaluate(const AF2Binding&) const override { return value_; }

 private:
  double value_;
};

TEST(SampledChecks, FindRulesThatAreNeverChosen) {
  RuleDefinition rule = testing::right60().definition();
  rule.name = "dearer right 60";
  rule.cost = std::make_shared<ConstantCost>(0.1);
  const SampledResult result = withRule(AF2Rule(rule));
  const SampledFinding* finding = find(result, "D3", 0);
  ASSERT_TRUE(finding);
  EXPECT_NE(finding->message.find("rule 'dearer right 60' was never chosen in 1000 situations"),
            std::string::npos)
      << finding->message;
}

TEST(SampledChecks, DoNotBlameARuleThatIsSometimesChosen) {
  RuleDefinition rule = testing::right60().definition();
  rule.name = "cheaper right 60";
  rule.cost = std::make_shared<ConstantCost>(-0.1);
  EXPECT_FALSE(find(withRule(AF2Rule(rule)), "D3", 0));
}

TEST(SampledChecks, PassOverRulesThatAreNeverReached) {
  RuleDefinition rule = testing::right60().definition();
  rule.name = "switched off";
  rule.firstLevel = 1000;
  const SampledResult result = withRule(AF2Rule(rule));
  EXPECT_TRUE(result.findings.empty());
  EXPECT_EQ(result.answers[0].positive, Answer::Sampled);
}

TEST(SampledChecks, SumUpWhatIsProven) {
  EXPECT_EQ(
      summaryOf(ofTriangles()),
      "12 rules; elements positive (G2): proven for 12; inside the free zone (Z1): proven for "
      "12");
  EXPECT_EQ(
      summaryOf(ofQuads()),
      "5 rules; elements positive (G2): proven for 4, false for 1; inside the free zone (Z1): "
      "proven for 4, false for 1");
}

TEST(SampledChecks, AreTheSameEveryTime) {
  const SampledResult again = runSampledChecks(testing::quadSet());
  ASSERT_EQ(again.findings.size(), ofQuads().findings.size());
  for (std::size_t i = 0; i < again.findings.size(); ++i) {
    EXPECT_EQ(again.findings[i].message, ofQuads().findings[i].message);
    EXPECT_EQ(again.findings[i].test, ofQuads().findings[i].test);
  }
}

/// What a finding's test claims is not so yet: it stands on the very piece of front.
TEST(SampledChecks, GiveExamplesThatShowTheFault) {
  const RuleSet rules = testing::quadSet();
  for (const SampledFinding& finding : ofQuads().findings) {
    if (finding.code != Code::UncoveredElement) continue;
    FrontPiece piece;
    piece.vertices = finding.example.vertices;
    piece.vertices.insert(piece.vertices.end(), finding.example.obstacles.begin(),
                          finding.example.obstacles.end());
    piece.chains = {{0, 1}};
    for (std::size_t i = 2; i < piece.vertices.size(); ++i) piece.isolated.push_back(i);
    piece.base = {0, 1};
    piece.level = finding.example.level;
    const SingleStep step = takeSingleStep(rules, piece);
    for (const RuleRefusal& refusal : step.refusals)
      EXPECT_FALSE(refusal.rule == finding.rule && refusal.reason == Refusal::ZoneHitByVertex);
  }
}

}  // namespace
}  // namespace af2::dsl
