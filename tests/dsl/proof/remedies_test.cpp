// Whoever does what a finding suggests is done with it: the finding is gone, the test that came
// with it passes, and no other finding asks for the way back.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "dsl/load/fixes.h"
#include "dsl/load/loaded_file.h"
#include "dsl/proof/coverage.h"
#include "dsl/proof/match_diagnostics.h"
#include "dsl/run/rule_tests.h"

namespace af2::dsl {
namespace {

const std::string kTriangleHead = "af2 1;\nruleset \"s\" { elements tri; match 0.5; }\n";

/// All that `af2 check` tells but of situations that are not covered.
std::vector<Diagnostic> findingsIn(const std::string& text) {
  const LoadedRules loaded = loadRulesFromText("r.af2", text);
  std::vector<Diagnostic> told = loaded.diagnostics;
  EXPECT_TRUE(loaded.rules) << toPretty(told) << text;
  if (!loaded.rules) return told;
  dropIdleMirrors(loaded, told);
  for (Diagnostic& d : told)
    if (const auto example = mirrorExampleOf(loaded, d)) d.notes.push_back(testNote(example->test));
  for (Diagnostic& d : diagnosticsOf(loaded, runSampledChecks(*loaded.rules)))
    addFinding(told, std::move(d));
  return told;
}

std::set<std::string> codesIn(const std::string& text) {
  std::set<std::string> codes;
  for (const Diagnostic& d : findingsIn(text)) codes.insert(idOf(d.code));
  return codes;
}

using CodeIds = std::set<std::string>;

const Diagnostic* firstOf(const std::vector<Diagnostic>& told, Code code) {
  const auto found = std::ranges::find(told, code, &Diagnostic::code);
  return found == told.end() ? nullptr : &*found;
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, text.npos) << part << " in " << text;
  return at == text.npos ? text : text.replace(at, part.size(), by);
}

std::string failuresOf(const std::string& text) {
  const LoadedRules loaded = loadRulesFromText("r.af2", text);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics) << text;
  std::string failures;
  for (const TestResult& result : runRuleTests(loaded))
    if (!result.passed()) failures += toText(result);
  return failures;
}

// ---- D3 says why
// ---------------------------------------------------------------------------------

std::string whyNeverChosen(const std::string& rules) {
  const auto told = findingsIn(rules);
  const Diagnostic* finding = firstOf(told, Code::NeverChosen);
  return finding ? finding->message + " / " + finding->help : toPretty(told);
}

const std::string kBetter =
    "rule \"better\" quality 1 { new c = mid(a, b) + (0, 0.866); zone a, b, c; tri a b c; }\n";

TEST(NeverChosen, NamesTheRuleThatWinsAndBothScores) {
  const std::string why = whyNeverChosen(
      kTriangleHead + kBetter +
      "rule \"dear\" quality 1 { new c = mid(a, b) + (0, 0.866); zone a, b, c; tri a b c; cost 5; "
      "}\n");
  EXPECT_NE(why.find("in 1000 of them it was beaten, by rule 'better', whose score was "), why.npos)
      << why;
  EXPECT_NE(why.find(" where this one's was 5"), why.npos) << why;
  EXPECT_NE(
      why.find(" / remove it, give it a smaller free zone, or lower its `cost` by more than 5"),
      why.npos)
      << why;
}

TEST(NeverChosen, TellsTies) {
  const std::string why =
      whyNeverChosen(kTriangleHead + kBetter + replaced(kBetter, "better", "same"));
  EXPECT_NE(why.find("by rule 'better', which had the same score of "), why.npos) << why;
  EXPECT_NE(why.find("smaller `priority`"), why.npos) << why;
}

TEST(NeverChosen, TellsScoresThatAreNotAccepted) {
  const std::string why =
      whyNeverChosen("af2 1;\nruleset \"s\" { elements tri; accept score < 0.1*q; }\n" +
                     replaced(kBetter, "tri a b c;", "tri a b c; cost 4; meta { allow \"N1\"; }"));
  EXPECT_NE(why.find("its score was not accepted: it was 4 at best (level 7), and `accept` allows "
                     "less than 0.7"),
            why.npos)
      << why;
  EXPECT_NE(why.find("accept higher scores"), why.npos) << why;
}

TEST(NeverChosen, TellsThatThereIsNoValue) {
  const std::string why = whyNeverChosen(
      kTriangleHead + replaced(kBetter, "tri a b c;",
                               "tri a b c; cost if q > 30 then 1 else sqrt(0.5 - len(b - a));"));
  EXPECT_NE(why.find("in 1000 of them it had no value"), why.npos) << why;
  EXPECT_NE(why.find("have a value"), why.npos) << why;
}

// ---- mirror images
// -------------------------------------------------------------------------------

/// No vertex of the pattern can break the tie: both diagonals of the square always score the same.
const std::string kOneDiagonal = R"(rule "square" quality 1 {
  new  c = b + (0, 1), d = a + (0, 1);
  zone a, b, c, d;
  tri  a b c, a c d;
}
)";

/// The diagonals of a quadrilateral that is matched differ in their scores.
const std::string kMatchedDiagonal = R"(rule "quadrilateral" quality 1 {
  front d -> a -> b -> c;
  at    c (1, 1), d (0, 1);
  require convex(a, b, c, d);
  zone  a, b, c, d;
  tri   a b c, a c d;
}
)";

std::string withMirror(const std::string& rules) {
  return std::string(rules).insert(rules.rfind("}"), "  mirror \"mirrored\";\n");
}

TEST(MirrorImages, AreNotAskedForWhereTheyWouldAlwaysTie) {
  EXPECT_EQ(codesIn(kTriangleHead + kOneDiagonal), CodeIds{});
  const auto told = findingsIn(kTriangleHead + withMirror(kOneDiagonal));
  ASSERT_EQ(told.size(), 1u) << toPretty(told);
  EXPECT_EQ(idOf(told[0].code), "M2");
  EXPECT_NE(told[0].message.find("never chosen"), std::string::npos) << told[0].message;
  ASSERT_EQ(told[0].edits.size(), 1u);
}

TEST(MirrorImages, AreAskedForWhereTheyAreSometimesBetter) {
  const auto told = findingsIn(kTriangleHead + kMatchedDiagonal);
  const Diagnostic* missing = firstOf(told, Code::MissingMirror);
  ASSERT_TRUE(missing) << toPretty(told);
  EXPECT_EQ(missing->label, "its image differs in elements");
  const CodeIds after = codesIn(kTriangleHead + withMirror(kMatchedDiagonal));
  EXPECT_FALSE(after.contains("M1") || after.contains("M2") || after.contains("D3"));
}

/// The image would be told to be never chosen, so nobody is asked to add it.
TEST(MirrorImages, AreNotAskedForWhereOtherRulesAlwaysBeatThem) {
  const std::string right =
      "rule \"right\" quality 1 {\n  front a -> b -> c;\n  at    c (0.5, 0.866) ~ 3;\n"
      "  zone  a, b, c;\n  tri   a b c;\n}\n";
  const std::string left =
      "rule \"left\" quality 1 {\n  front d -> a -> b;\n  at    d (0.52, 0.866) ~ 2;\n"
      "  zone  a, b, d;\n  tri   a b d;\n  cost  -1;\n  meta  { allow \"M1\"; }\n}\n";
  EXPECT_FALSE(codesIn(kTriangleHead + right + left).contains("M1"));
  EXPECT_TRUE(codesIn(kTriangleHead + right).contains("M1"));
  const auto fixed = [](const std::string& text) {
    return fixText("r.af2", text, {}, dropIdleMirrors).text;
  };
  EXPECT_EQ(fixed(kTriangleHead + right + left), kTriangleHead + right + left);
  EXPECT_NE(fixed(kTriangleHead + right), kTriangleHead + right);
}

// ---- remedies
// ------------------------------------------------------------------------------------

struct Mended {
  const char* name;
  Code code;
  std::string before, part, by;  ///< the remedy: what is replaced
};

const std::string kList = R"(rule "list" quality 1..3 {
  front  a -> b -> c;
  at     c (0.5, 0.866);
  zone   a, b, lerp(a, mid(b, c), 0.9), c;
  tri    a b c;
  mirror "list, left";
  meta   { allow "Z1 G2"; }
}
)";
const std::string kLow = R"(rule "low" quality 1..4 {
  front  a -> b -> c;
  at     c (0.5, 0.7);
  zone   (hull(a, b, c));
  tri    a b c;
  mirror "low, left";
}
)";
const std::string kShort = R"(rule "short" quality 1 {
  new  c = mid(a, b) + (0, 0.866);
  zone a, b, b + (0, 0.8), a + (0, 0.8);
  tri  a b c;
}
)";
const std::string kGrowing = R"(rule "grows" quality 1 {
  new  c = mid(a, b) + (0, 0.866);
  zone a, b, c + (0.01, 0) => c + (0.1, 0.1), c - (0.01, 0);
  tri  a b c;
  meta { allow "M1"; }
}
)";
const std::string kShadowed = R"(rule "better" quality 1 {
  new  c = mid(a, b) + (0, 0.866);
  zone a, b, c;
  tri  a b c;
}
rule "shadowed" quality 1 {
  new  c = mid(a, b) + (0, 0.866);
  zone a, b, c;
  tri  a b c;
  cost 0.1;
}
)";
const std::string kNever = R"(rule "never" quality 1 {
  at      c (0.5, 1);
  require c.y > 5;
  zone    (poly(a, b, c));
  tri     a b c;
  meta    { allow "D4 G2"; }
}
)";
const std::string kRight = R"(rule "right" quality 1 {
  front a -> b -> c;
  at    c (1.5, 0.866) ~ 3;
  new   d = a + (c - b);
  zone  a, b, c, d;
  tri   a b d, b c d;
}
)";

const std::vector<Mended> kMended{
    {"InvertedByRequire", Code::InvertibleElement, kLow, "  zone ",
     "  require ccw(a, b, c);\n  zone "},
    {"InvertedByTolerance", Code::InvertibleElement, kLow, "(0.5, 0.7)", "(0.5, 0.7) ~ 20"},
    {"InvertedByLevels", Code::InvertibleElement,
     replaced(kLow, "(0.5, 0.7)", "(0.5, 0.7) ~ (1, 0, if q < 3 then 20 else 0.1)"), "1..4",
     "1..2"},
    {"Uncovered", Code::UncoveredElement, kShort, "b + (0, 0.8), a + (0, 0.8)",
     "b + (0, 1), a + (0, 1)"},
    {"InvalidZone", Code::InvalidZone, kList, "a, b, lerp(a, mid(b, c), 0.9), c",
     "poly(a, b, lerp(a, mid(b, c), 0.9), c)"},
    {"Growing", Code::GrowingZone, kGrowing, "c + (0.01, 0) => c + (0.1, 0.1)",
     "c + (0.01, 0) => c"},
    {"BeatenByCost", Code::NeverChosen, kShadowed, "cost 0.1", "cost -0.01"},
    {"NeverHolds", Code::IdleClause, kNever, "c.y > 5", "c.y > 0.95"},
    {"NoMirror", Code::MissingMirror, kRight, "  tri   a b d, b c d;\n",
     "  tri   a b d, b c d;\n  mirror \"left\";\n"},
};

void PrintTo(const Mended& mended, std::ostream* stream) { *stream << mended.name; }

class Remedy : public ::testing::TestWithParam<Mended> {};

TEST_P(Remedy, MakesTheTestPass) {
  const Mended& mended = GetParam();
  const auto told = findingsIn(kTriangleHead + mended.before);
  const Diagnostic* finding = firstOf(told, mended.code);
  ASSERT_TRUE(finding) << toPretty(told);
  std::string tests;
  for (const DiagnosticNote& note : finding->notes)
    if (note.kind == DiagnosticNote::Kind::Test) tests += note.message + "\n";
  ASSERT_FALSE(tests.empty()) << toPretty(*finding);
  EXPECT_NE(failuresOf(kTriangleHead + mended.before + tests), "") << tests;
  const std::string after = kTriangleHead + replaced(mended.before, mended.part, mended.by);
  EXPECT_EQ(failuresOf(after + tests), "") << tests << toPretty(findingsIn(after));
  const auto left = findingsIn(after);
  EXPECT_TRUE(std::ranges::none_of(left, [&](const Diagnostic& d) {
    return d.code == mended.code && d.rule == finding->rule;
  })) << toPretty(left);
}

INSTANTIATE_TEST_SUITE_P(Finding, Remedy, ::testing::ValuesIn(kMended),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Remedies, NameTheConditionThatKeepsAnElementPositive) {
  const auto told = findingsIn(kTriangleHead + kLow);
  const Diagnostic* finding = firstOf(told, Code::InvertibleElement);
  ASSERT_TRUE(finding);
  EXPECT_NE(finding->help.find("`require ccw(a, b, c)`"), std::string::npos) << finding->help;
}

/// More generous acceptance is proposed where it helps, and only there.
TEST(Remedies, OfUncoveredSituationsSayWhetherTheScoreIsAtFault) {
  const auto uncovered = [](const std::string& text) {
    const LoadedRules loaded = loadRulesFromText("r.af2", text);
    EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
    return findUncoveredSituations(measureCoverage(*loaded.rules)).value();
  };
  const std::string rule =
      "rule \"free\" quality 1 { new c = mid(a, b) + (0, 0.8); zone a, b, c; tri a b c; }\n";
  EXPECT_EQ(uncovered(kTriangleHead + rule).help.find("accept"), std::string::npos);
  const std::string strict =
      "af2 1;\nruleset \"s\" { elements tri; accept score < if q > 20 then 9 else 0.0001; }\n";
  const SampledFinding finding = uncovered(strict + rule);
  EXPECT_NE(finding.help.find("bound of `accept`"), std::string::npos) << finding.help;
  std::string tests = finding.test;
  for (const std::string& test : finding.furtherTests) tests += test;
  EXPECT_NE(failuresOf(strict + rule + tests), "");
  EXPECT_EQ(failuresOf(replaced(strict, "0.0001", "9") + rule + tests), "");
}

/// Every edit that M1 or M2 brings along leaves a file in which neither of them, nor D3, speaks of
/// the rule again.
TEST(Remedies, OfMirrorsDoNotGoRoundInACircle) {
  namespace fs = std::filesystem;
  for (const char* folder : {"codes/found", "codes/sound", "proof/cases"})
    for (const auto& entry :
         fs::directory_iterator(fs::path(AF2_SOURCE_DIR "/tests/dsl") / folder)) {
      if (entry.path().extension() != ".af2") continue;
      std::ifstream file(entry.path(), std::ios::binary);
      std::ostringstream text;
      text << file.rdbuf();
      const LoadedRules loaded = loadRulesFromText("r.af2", text.str());
      if (!loaded.rules) continue;
      std::vector<Diagnostic> told = loaded.diagnostics;
      dropIdleMirrors(loaded, told);
      for (const Diagnostic& d : told) {
        const bool isMirror = d.code == Code::MissingMirror || d.code == Code::RedundantMirror;
        if (!isMirror || d.edits.empty()) continue;
        const DiagnosticPlace& place = d.edits[0].place;
        std::istringstream lines(text.str());
        std::string edited, line;
        for (int number = 1; std::getline(lines, line); ++number) {
          // Mirror clauses stand on one line; those that are taken away begin at the end of
          // another.
          if (number == place.line && place.line == place.endLine)
            line.replace(static_cast<std::size_t>(place.column - 1),
                         static_cast<std::size_t>(place.endColumn - place.column),
                         d.edits[0].replacement);
          else if (number == place.line)
            line.erase(static_cast<std::size_t>(place.column - 1));
          else if (number == place.endLine)
            line.erase(0, static_cast<std::size_t>(place.endColumn - 1));
          edited += line + "\n";
        }
        for (const Diagnostic& after : findingsIn(edited))
          EXPECT_FALSE(after.rule == d.rule &&
                       (after.code == Code::MissingMirror || after.code == Code::RedundantMirror ||
                        after.code == Code::NeverChosen) &&
                       !firstOf(told, after.code))
              << entry.path() << "\n"
              << toPretty(after);
      }
    }
}

}  // namespace
}  // namespace af2::dsl
