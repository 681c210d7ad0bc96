#include "dsl/run/explain.h"

#include <gtest/gtest.h>

#include "dsl/load/rule_file.h"
#include "dsl/run/piece_text.h"
#include "dsl/run/rule_tests.h"

namespace af2::dsl {
namespace {

constexpr const char* kTwoRules = R"(
af2 1;
ruleset "two rules" {
  elements tri;
  match    0.1*q;
  score    max of shape_size(10);
  accept   score < 1 + q;
  front    by q;
}
rule "apex" quality 1 {
  new  c = mid(a, b) + (0, 0.866);
  zone a, b, c + (0.5, 0), c + (0, 0.5), c - (0.5, 0);
  tri  a b c;
}
rule "corner" quality 1 {
  front a -> b -> c;
  at    c (0.5, 0.866);
  zone  a, b, c;
  tri   a b c;
}
)";

LoadedRules loadTwo(const std::string& more = {}) {
  LoadOptions options;
  options.allowed = {Code::MissingMirror};
  return loadRulesFromText("two.af2", kTwoRules + more, options);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class Explain : public ::testing::Test {
 protected:
  StepExplanation explain(const FrontPiece& piece) {
    return explainStep(*loaded.rules, stepper, piece, vertexNamesOf(piece), true);
  }

  LoadedRules loaded = loadTwo();
  SingleStepper stepper{*loaded.rules};
};

FrontPiece cornerAt(Point2 c, std::vector<Point2> points = {}) {
  FrontPiece piece;
  piece.vertices = {{0, 0}, {1, 0}, c};
  piece.chains = {{0, 1, 2}};
  for (const Point2 p : points) {
    piece.isolated.push_back(piece.vertices.size());
    piece.vertices.push_back(p);
  }
  piece.base = {0, 1};
  return piece;
}

TEST_F(Explain, NamesTheVertexInTheZoneAndItsDepth) {
  const StepExplanation explained = explain(cornerAt({2, -1}, {{0.5, 0.9}}));
  EXPECT_FALSE(explained.applied);
  EXPECT_EQ(explained.rules[0].reason, Refusal::ZoneHitByVertex);
  EXPECT_TRUE(contains(explained.rules[0].because, "vertex p2 at (0.5, 0.9)"))
      << explained.rules[0].because;
  EXPECT_TRUE(contains(toText(explained), "most frequent reason: zone hit by vertex"));
}

TEST_F(Explain, SaysByHowMuchTheNearestVertexDeviatesAndAtWhichLevelItMatches) {
  const StepExplanation explained = explain(cornerAt({0.5, 1.2}));
  EXPECT_EQ(explained.rules[1].reason, Refusal::Pattern);
  EXPECT_EQ(explained.rules[1].matches, 0u);
  EXPECT_TRUE(contains(explained.rules[1].because, "vertex c deviates by 0.1116"));
  EXPECT_TRUE(contains(explained.rules[1].because, "at most 0.1 is allowed"));
  EXPECT_EQ(explained.rules[1].passesAtLevel, 2);
  EXPECT_TRUE(contains(toText(explained, "", "corner"), "passes at level 2"));
  EXPECT_FALSE(contains(toText(explained, "", "corner"), "apex"));
}

TEST_F(Explain, ShowsTheRuleThatWasApplied) {
  const StepExplanation explained = explain(cornerAt({0.5, 0.9}));
  ASSERT_TRUE(explained.applied);
  EXPECT_EQ(explained.rules[*explained.applied].rule, "corner");
  EXPECT_TRUE(contains(toJson(explained), "\"applied\": \"corner\""));
  EXPECT_FALSE(contains(toText(explained), "most frequent reason"));
}

TEST_F(Explain, IsThereForAFailedTest) {
  const LoadedRules tested = loadTwo(
      "test \"blocked\" { front a (0, 0) -> b (1, 0); point o (0.5, 0.9); expect not stuck; }\n");
  const auto results = runRuleTests(tested);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_FALSE(results[0].passed());
  EXPECT_TRUE(contains(toText(results[0]), "vertex o at (0.5, 0.9) lies in the zone"));
}

TEST(PieceText, GivesATestOfTheSamePiece) {
  FrontPiece piece = cornerAt({0.1 + 0.2, 1.0 / 3}, {{-0.25, 7}});
  piece.level = 3;
  piece.size = 1.5;
  const std::string text = testTextOf(piece, {"a \"title\"", "why", "not stuck"});
  EXPECT_TRUE(contains(text, "# why\ntest \"a \\\"title\\\"\" {"));
  const LoadedRules loaded = loadTwo(text);
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  const auto results = runRuleTests(loaded);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].title, "a \"title\"");
  EXPECT_TRUE(contains(text, "p1 (0.30000000000000004, 0.3333333333333333)"));
  EXPECT_TRUE(contains(text, "point  p2 (-0.25, 7);"));
  EXPECT_TRUE(contains(text, "class  3;"));
  EXPECT_TRUE(contains(text, "size   1.5;"));
}

}  // namespace
}  // namespace af2::dsl
