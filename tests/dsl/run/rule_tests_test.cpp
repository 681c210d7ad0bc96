#include "dsl/run/rule_tests.h"

#include <gtest/gtest.h>

namespace af2::dsl {
namespace {

const std::string kRules = R"(af2 1;
ruleset "s" { match 0.5 + 0.3*q; accept score < 2 + 0.5*q^2; }
rule "free" quality 1 {
  new  c = mid(a, b) + (0, 0.866);
  zone a, b, mid(a, b) + (1, 0.7), mid(a, b) + (0, 1.5), mid(a, b) + (-1, 0.7);
  tri  a b c;
}
rule "corner" quality 1 {
  front a -> b -> c;
  at    c (0.5, 0.866);
  require turn(b) < 90deg;
  zone  a, b, c;
  tri   a b c;
  mirror "corner left";
}
)";

LoadedRules load(const std::string& tests) { return loadRulesFromText("test.af2", kRules + tests); }

std::vector<std::string> outcomes(const std::string& tests) {
  const LoadedRules rules = load(tests);
  EXPECT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  std::vector<std::string> result;
  for (TestResult& r : runRuleTests(rules)) {
    r.explanation.clear();  // see explain_test.cpp
    result.push_back(toText(r));
  }
  return result;
}

std::vector<std::string> faults(const std::string& tests) {
  std::vector<std::string> result;
  for (const Diagnostic& d : load(tests).diagnostics)
    result.push_back(idOf(d.code) + ": " + d.message);
  return result;
}

using Lines = std::vector<std::string>;

TEST(RuleTests, PassWhereTheEngineDoesWhatIsExpected) {
  EXPECT_EQ(outcomes(R"(test "t" {
    front p (0, 0) -> r (2, 0);
    size 2;
    expect rule "free";
    expect new 1 at (1, 1.732);
    expect front only p -> new 1 -> r;
    expect elements 1;
    expect not stuck;
    expect score < 0.1;
    expect dist(p, r) == 2;
  })"),
            Lines{"ok    t\n"});
}

TEST(RuleTests, TellWhatCameInstead) {
  EXPECT_EQ(outcomes(R"(test "t" {
    front p (0, 0) -> r (1, 0), u (-1, 1) -> v (2, 1);
    expect rule "free";
  })"),
            Lines{"FAIL  t   test.af2:16\n      expected: rule \"free\"   (line 18)\n"
                  "      got:      no rule; \"free\" was refused: zone hit by edge u -> v\n"});
}

TEST(RuleTests, KnowWhyARuleIsRefused) {
  EXPECT_EQ(outcomes(R"(test "t" {
    front p (0, 0) -> r (1, 0) -> s (1.05, 0.9);
    point w (0.5, 1);
    expect not rule "corner" because require;
    expect not rule "corner left" because pattern;
    expect not rule "free" because zone hit by vertex w;
  })"),
            Lines{"ok    t\n"});
}

TEST(RuleTests, TakeOneOfSeveralReasons) {
  const std::string front = "front p (0, 0) -> r (1, 0) -> s (1.05, 0.9); point w (0.5, 1);";
  EXPECT_EQ(outcomes("test \"t\" {" + front +
                     "expect not rule \"corner\" because pattern or require or class;"
                     "expect not rule \"free\" because score or zone hit by vertex w; }"),
            Lines{"ok    t\n"});
  EXPECT_NE(
      outcomes("test \"t\" {" + front + "expect not rule \"corner\" because pattern or score; }")[0]
          .find("\"corner\" was refused: require"),
      std::string::npos);
}

/// The front of a test lies in a plane, so that this reason is known but never comes.
TEST(RuleTests, MayExpectThatTheSurfaceRefuses) {
  const auto told = outcomes(
      "test \"t\" { front p (0, 0) -> r (1, 0); expect not rule \"corner\" because surface; }");
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("\"corner\" was refused: pattern"), std::string::npos) << told[0];
}

TEST(RuleTests, KnowAllThatHitsAZone) {
  EXPECT_EQ(outcomes(R"(test "t" {
    front p (0, 0) -> r (1, 0), u (-1, 1) -> v (2, 1), w (-1, 1.2) -> x (2, 1.2), m (3, 0) -> n (3, 1);
    expect not rule "free" because zone hit by edge u -> v;
    expect not rule "free" because zone hit by edge w -> x;
  }
  test "vertices and edges" {
    front p (0, 0) -> r (1, 0), u (-1, 1) -> v (2, 1);
    point w (0.5, 0.5), x (0.6, 0.5);
    expect not rule "free" because zone hit by edge u -> v;
    expect not rule "free" because zone hit by vertex w;
    expect not rule "free" because zone hit by vertex x;
  })"),
            (Lines{"ok    t\n", "ok    vertices and edges\n"}));
  const Lines failed = outcomes(R"(test "t" {
    front p (0, 0) -> r (1, 0), u (-1, 1) -> v (2, 1), m (3, 0) -> n (3, 1);
    expect not rule "free" because zone hit by edge m -> n;
  })");
  ASSERT_EQ(failed.size(), 1u);
  EXPECT_NE(failed[0].find("FAIL"), std::string::npos);
}

TEST(RuleTests, BindMirrorsAndBases) {
  EXPECT_EQ(outcomes(R"(test "t" {
    front s (0.5, 0.9) -> p (0, 0) -> r (1, 0);
    base p -> r;
    expect rule "corner left" with c = s;
    expect turn(p) < 90deg;
  })"),
            Lines{"ok    t\n"});
}

TEST(RuleTests, AreCheckedBeforeTheyRun) {
  EXPECT_EQ(faults("test \"t\" { front p (0, 0) -> r (1, 0); expect rule \"fre\"; }"),
            Lines{"R1: there is no rule \"fre\""});
  EXPECT_EQ(faults("test \"t\" { front p (0, 0) -> r (1, 0); expect front p -> s; }"),
            Lines{"R1: this test has no vertex 's'"});
  EXPECT_EQ(faults("test \"t\" { front p (0, 0) -> r (1, 0); expect turn(p) < 90deg; }"),
            Lines{"Y5: this vertex has no turn"});
  EXPECT_EQ(faults("test \"t\" { front p (0, 0) -> r (1, 0); expect valence(p) < 3; }"),
            Lines{"Y5: 'valence' is not available in a test, which has no mesh around it"});
  EXPECT_EQ(faults("test \"t\" { front p (0, 0) -> r (1, 0), p (1, 1) -> r; expect stuck; }"),
            Lines{"R2: the vertex 'p' is placed twice"});
}

TEST(RuleTests, HoldPropertiesAgainstMatches) {
  EXPECT_EQ(
      outcomes(
          R"(property "p" forall match of "corner", t in 1..3 { expect dist(a, c) < 4; expect t <= 3; })"),
      Lines{"ok    p\n"});
  const Lines failed =
      outcomes(R"(property "p" forall match of "corner left" { expect dist(b, c) < 0.9; })");
  ASSERT_EQ(failed.size(), 1u);
  EXPECT_NE(failed[0].find("it fails at level 1 for b = ("), std::string::npos) << failed[0];
}

TEST(RuleTests, TryPropertiesOnMatchesOfTheFrontOnly) {
  const auto outcomeOf = [](const std::string& setting, const std::string& property) {
    const LoadedRules rules = loadRulesFromText("property.af2", R"(af2 1;
ruleset "s" { match 1; )" + setting + R"( }
rule "corner" quality 2..4 {
  front a -> b -> c;
  at    c (0.5, 0.866) ~ 3;
  slope b -> c ~ (6, 0, 1);
  zone  a, b, c;
  tri   a b c;
}
property "p" forall match of "corner", t in )" + property);
    EXPECT_TRUE(rules.rules) << toPretty(rules.diagnostics);
    return runRuleTests(rules).at(0).passed();
  };
  EXPECT_TRUE(outcomeOf("", "2..4 { expect 6 * (c.x - b.x + 0.5)^2 < 1.001; }")) << "the slope";
  EXPECT_TRUE(outcomeOf("scale base;", "2..4 { expect dist(a, b) == 1; }"));
  EXPECT_TRUE(outcomeOf("", "2..4 { expect 0.7 <= dist(a, b) and dist(a, b) <= 1.4; }"));
  EXPECT_FALSE(outcomeOf("", "2..4 { expect dist(a, b) < 1.35; }"));
  EXPECT_FALSE(outcomeOf("", "2..4 { expect dist(a, b) > 0.75; }"));
  EXPECT_TRUE(outcomeOf("", "1..9 { expect 2 <= t and t <= 4; }")) << "where the rule applies";
}

void expectAllPass(const char* file, std::size_t atLeast) {
  const LoadedRules rules = loadRules(file);
  ASSERT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  const auto results = runRuleTests(rules);
  EXPECT_GE(results.size(), atLeast);
  for (const TestResult& result : results) EXPECT_TRUE(result.passed()) << toText(result);
}

TEST(RuleTests, OfTheClassicalTrianglesPass) {
  expectAllPass(AF2_SOURCE_DIR "/rules/tri/classic.af2", 11);
}

TEST(RuleTests, OfTheClassicalQuadsPass) {
  expectAllPass(AF2_SOURCE_DIR "/rules/quad/classic.af2", 18);
}

/// A rule that joins the base edge to a vertex across, and one that welds.
const std::string kEvenRules = R"(af2 1;
ruleset "even" { elements quad; parity even; score max of jacobian_badness; }
rule "meet" quality 1 {
  near c of b + (0, 1) within 0.4;
  new  d = a + (0, 1);
  zone poly(a, b, c, d);
  quad a b c d;
}
rule "seam" quality 1 {
  front    a -> b -> c;
  at       c (0.5, 0.2) ~ any;
  require  turn(b) < 32deg;
  weld     c into a at mid(a, c);
  priority -1;
}
)";

TEST(RuleTests, StateColours) {
  const std::string front =
      "front o (-1, 0) -> p (0, 0) -> r (1, 0) -> s (2, 0), v (1.8, 1.8) -> w (1, 1) -> x (0, 2);"
      "base p -> r;";
  const LoadedRules rules = loadRulesFromText(
      "even.af2", kEvenRules + "test \"like\" {" + front +
                      "colours r 1, w 1; expect not rule \"meet\" because parity; }\n"
                      "test \"unlike\" {" +
                      front + "colours s 0, x 1; expect rule \"meet\" with c = w; }\n" +
                      "test \"two loops\" {" + front + "expect rule \"meet\" with c = w; }\n");
  ASSERT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  for (const TestResult& result : runRuleTests(rules))
    EXPECT_TRUE(result.passed()) << toText(result);
}

TEST(RuleTests, ExpectWelds) {
  const std::string front =
      "front o (-1, 0.2) -> p (0, 0) -> r (1, 0) -> s (0, 0.2) -> t (-1, 0.6); base p -> r;";
  const LoadedRules rules =
      loadRulesFromText("even.af2", kEvenRules + "test \"welds\" {" + front +
                                        "expect weld s into p; expect not weld p into s; }\n"
                                        "test \"other\" {" +
                                        front + "expect weld p into s; }\n");
  ASSERT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  const auto results = runRuleTests(rules);
  EXPECT_TRUE(results[0].passed()) << toText(results[0]);
  EXPECT_NE(toText(results[1]).find("weld s into p by rule \"seam\""), std::string::npos)
      << toText(results[1]);
}

TEST(RuleTests, ReportColoursThatCannotBe) {
  const std::string front = "test \"t\" { front p (0, 0) -> r (1, 0) -> s (2, 0); expect stuck; ";
  EXPECT_EQ(faults(front + "colours p 0, s 1; }"),
            Lines{"S10: the colour of 's' contradicts one that is given before"});
  EXPECT_EQ(faults(front + "colours p 2; }"), Lines{"Y3: a colour is 0 or 1"});
  EXPECT_EQ(faults(front + "point u (5, 5); colours u 0; }"),
            Lines{"S10: the vertex 'u' is not on an open chain of the front"});
  EXPECT_EQ(faults(front + "colours q 0; }"), Lines{"R1: this test has no vertex 'q'"});
}

}  // namespace
}  // namespace af2::dsl
