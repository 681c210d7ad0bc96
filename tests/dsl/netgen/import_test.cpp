#include <gtest/gtest.h>

#include <random>

#include "dsl/load/rule_file.h"
#include "dsl/netgen/rls_import.h"

namespace af2::dsl {
namespace {

/// A sound rule; tests replace parts of it.
const std::string kRule =
    "rule \"corner\"\n"
    "quality 1\n"
    "mappoints\n(0, 0);\n(1, 0);\n(0.5, 0.8);\n"
    "maplines\n(1, 2) del;\n(2, 3) del;\n"
    "newlines\n(1, 3);\n"
    "freearea\n(0, 0);\n(1, 0) { 1 X2 } { };\n(0.5, 0.8) { 1 X3 } { 1 Y3 };\n"
    "elements\n(1, 2, 3);\n"
    "endrule\n";

std::string with(std::string part, const std::string& replacement) {
  std::string text = kRule;
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), replacement);
}

/// Findings, one a line: "line 3: error I1: message; help".
std::string told(const std::string& text) {
  std::string result;
  for (const Diagnostic& d : importRls("x.rls", text).diagnostics)
    result += "line " + std::to_string(d.place.line) + ": " +
              (d.severity == Severity::Error ? "error " : "warning ") + idOf(d.code) + ": " +
              d.message + "; " + d.help + "\n";
  return result;
}

void expectTold(const std::string& text, const std::string& part) {
  const std::string all = told(text);
  EXPECT_NE(all.find(part), std::string::npos) << "missing: " << part << "\ntold:\n" << all;
}

TEST(ImportRls, GivesAFileThatLoads) {
  const ImportedRules imported = importRls("x.rls", kRule);
  const LoadedRules loaded = loadRulesFromText("x.af2", imported.text);
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics) << imported.text;
  EXPECT_EQ(loaded.rules->rules().size(), 1u);
  EXPECT_EQ(loaded.rules->name(), "x");
  EXPECT_EQ(loaded.rules->maxLevel(), 200);
}

TEST(ImportRls, TakesCoordinatesInAnyCaseAndCommasOrNone) {
  const std::string other = with("{ 1 X3 } { 1 Y3 }", "{1x3}\t{ 0.0 Y2 +1.0E0 y3 }");
  EXPECT_EQ(importRls("x.rls", other).text, importRls("x.rls", kRule).text);
}

TEST(ImportRls, RowsSayWhichCoordinateIsMade) {
  const std::string crossed = with("{ 1 X3 } { 1 Y3 }", "{ 1 Y3 } { 1 X3 }");
  EXPECT_NE(importRls("x.rls", crossed).text.find("a + (c.y - 0.3, c.x + 0.3)"), std::string::npos)
      << importRls("x.rls", crossed).text;
}

TEST(ImportRls, KeepsTolerancesOfEdges) {
  const std::string text =
      importRls("x.rls", with("(2, 3) del;", "(2, 3) { 1, 0.5, 2 } del;")).text;
  EXPECT_NE(text.find("b -> c ~ (1, 0.5, 2)"), std::string::npos) << text;
}

TEST(ImportRls, LimitsBecomeFades) {
  const std::string text = importRls("x.rls", with("elements",
                                                   "freearea2\n(0, 0);\n(1, 0) { 1 X2 };\n"
                                                   "(0.5, 0.4) { 0.5 X3 , 0.5 X2 } { 0.5 Y3 };\n"
                                                   "elements"))
                               .text;
  EXPECT_NE(text.find("c => mid(b, c) + (-0.25, 0)"), std::string::npos) << text;
}

TEST(ImportRls, ReadsWhatNetgenReadsHoweverItIsLaidOut) {
  const auto same = [](const std::string& text) {
    const ImportedRules imported = importRls("x.rls", text);
    EXPECT_EQ(imported.text, importRls("x.rls", kRule).text) << told(text);
    return imported.diagnostics.size() == importRls("x.rls", kRule).diagnostics.size();
  };
  std::string windows = "\xEF\xBB\xBF";
  for (char c : kRule) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(same(windows));
  EXPECT_TRUE(same("\n\n\t " + with("rule \"corner\"", "rule\"corner\"") + "\n \n"));
  EXPECT_TRUE(same(with("{ 1 X3 } { 1 Y3 }", "{1.0e0X3}{ +1 Y 3, }")));
  EXPECT_TRUE(same(with("(0.5, 0.8);\nmaplines", "( 5e-1 ,\n.8 )\n;maplines")));
  EXPECT_TRUE(same(with("(1, 0);", "(1,0){1.0, 0, 1.0};"))) << "the usual form on an end";
  EXPECT_TRUE(same(with("quality 1", "quality\n1;")));
  EXPECT_TRUE(same(with("(1, 2) del;", "(1,2)del{0,0,0};")));
}

TEST(ImportRls, PassesOverWhatNetgenPassesOver) {
  const auto isSame = [](const std::string& text) {
    return importRls("x.rls", text).text == importRls("x.rls", kRule).text;
  };
  for (const auto& [text, warning] : {
           std::pair{with("quality 1", "quality 1\nflags a b;"),
                     "line 3: warning I4: 'flags' belongs to rules that fill volumes"},
           {with("quality 1", "tolfak 0.5\nquality 1"), "line 2: warning I4: 'tolfak' belongs"},
           {with("quality 1", "quality 1\nremember (1, 2);"),
            "line 3: warning I4: 'remember' is not a clause of a rule: it is ignored"},
           {with("(1, 3);", "(1, 3) del;"), "line 11: warning I5: 'del' has no effect here"},
           {with("Y3 };", "Y3 } whatever;"), "line 15: warning I5: 'whatever' has no effect here"},
       }) {
    EXPECT_TRUE(isSame(text)) << told(text);
    expectTold(text, warning);
  }
}

TEST(ImportRls, IsMoreGenerousThanNetgenWithCapitalsAndComments) {
  const auto isSame = [](const std::string& text) {
    return importRls("x.rls", text).text == importRls("x.rls", kRule).text;
  };
  std::string capitals = kRule;
  for (const char* word : {"rule \"", "quality", "mappoints", "maplines", "del", "elements",
                           "newlines", "freearea", "endrule"}) {
    const std::size_t at = capitals.find(word);
    capitals[at] = static_cast<char>(std::toupper(capitals[at]));
  }
  EXPECT_TRUE(isSame(capitals)) << told(capitals);
  expectTold(capitals, "line 2: warning I5: Netgen ignores 'Quality'");
  const std::string commented = "# corners, elements (1, 2, 3);\n" +
                                with("(1, 0);", "(1, 0); // the base, \"rule\"") +
                                "% the end of elements\n";
  EXPECT_TRUE(isSame(commented)) << told(commented);
  expectTold(commented, "line 1: warning I4: such files cannot contain comments");
}

TEST(ImportRls, TellsWhatNeverActs) {
  expectTold(with("(1, 0);", "(1, 0) { 0.5, 0, 1 };"), "line 5: warning I5: a tolerance on an end");
  expectTold(with("(0.5, 0.8);", "(0.5, 0.8) del;"), "line 6: warning I5: 'del' on a point");
  expectTold(with("1 X3", "1 X3, 1 X7"), "line 15: warning I5: there is no point 7 to follow");
  expectTold(with("1 X3", "2 X3, 1 X3"), "line 15: warning I5: this coordinate occurs twice");
  expectTold(with("quality 1", "quality 1000"), "line 2: warning I7: quality 1000 switches");
}

TEST(ImportRls, HoldsDelAndNewlinesAgainstTheElements) {
  expectTold(with("(2, 3) del;", "(2, 3);"), "line 9: warning I6: a new element lies at this edge");
  expectTold(with("(1, 3);", "(3, 1);"), "line 11: warning I6: this new line is not a free edge");
  expectTold(with("(1, 3);", "(3, 1);"), "free edge (1, 3) that newlines does not name");
  expectTold(with("(1, 2, 3);", "(1, 3, 2);"),
             "line 17: warning I6: this element does not run counter-clockwise where the rule "
             "expects its corners; with (1, 2, 3) instead");
}

TEST(ImportRls, TellsWhichRulesWillBeRefused) {
  expectTold(with("(1, 2, 3);", "(1, 3, 2);"),
             "line 1: warning I9: the imported rule will be refused");
}

TEST(ImportRls, ToleratesFaultsInRulesThatAreSwitchedOff) {
  std::string text = with("(1, 2, 3);", "(1, 3, 2);");
  text.replace(text.find("quality 1"), 9, "quality 300");
  const LoadedRules loaded = loadRulesFromText("x.af2", importRls("x.rls", text + kRule).text);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
}

TEST(ImportRls, TellsOfLimitsThatDoNotFit) {
  expectTold(with("elements", "freearea2\n(0, 0);\nelements"),
             "line 17: warning I6: freearea2 has 1 corners, freearea 3");
}

TEST(ImportRls, TellsOfLostRules) {
  expectTold(kRule + "rul \"lost\"\nquality 2\nendrule\n",
             "line 19: warning I4: a rule is lost here: it does not begin with the word 'rule'");
  expectTold("some words\n" + kRule, "line 1: warning I4: this text is outside of the rules");
}

TEST(ImportRls, ReadsProseThatSpeaksOfARule) {
  const std::string prose = "(* each rule below is for one corner *)\n";
  expectTold(prose + kRule, "line 1: warning I4: this text is outside of the rules");
  EXPECT_TRUE(loadRulesFromText("x.af2", importRls("x.rls", prose + kRule).text).rules);
}

TEST(ImportRls, TellsARuleForVolumesOnce) {
  const std::string solid =
      "rule \"solid\"\nquality 1\nmappoints\n(0, 0, 0);\n(1, 0, 0);\nmapfaces\n(1, 2, 3) del;\n"
      "newfaces\n(1, 2, 4);\nfreeset\n1 2 3;\nendrule\n";
  const std::string all = told(solid + solid);
  EXPECT_NE(all.find("line 6: error I3: 'mapfaces' belongs to rules that fill volumes"),
            std::string::npos)
      << all;
  EXPECT_NE(all.find("line 18: error I3"), std::string::npos) << all;
  EXPECT_EQ(all.find("I1"), std::string::npos) << all;
}

TEST(ImportRls, TellsErrorsWithTheirLines) {
  expectTold(with("mappoints", "mappoint"),
             "line 3: error I1: 'mappoint' is not a clause of a rule; did you mean 'mappoints'?");
  expectTold(with("(1, 0);", "(1 0);"), "line 5: error I1: expected ','");
  expectTold(with("(1, 0);", "(1, zero);"), "line 5: error I1: expected a number");
  expectTold(with("{ 1 X3 }", "{ X3 }"), "line 15: error I1: expected a number, found 'X3'");
  expectTold(with("{ 1 X3 }", "{ 1 Z3 }"), "line 15: error I1: expected a coordinate");
  expectTold(with("quality 1", "quality 1.5"), "line 2: error I2: a quality is a whole number");
  expectTold(with("(1, 2, 3);", "(1, 2, 4);"), "line 17: error I2: there is no point 4");
  expectTold(with("(1, 2, 3);", "(1, 2);"), "line 17: error I1");
  expectTold(with("endrule", ""), "line 1: error I1: this rule does not end");
  expectTold(with("elements\n(1, 2, 3);\n", ""), "error I2: this rule makes no elements");
  expectTold(with("quality 1", "mapfaces (1, 2, 3);"), "line 2: error I3");
  expectTold(with("(2, 3) del;", "(2, 3) del;\n(2, 1);"), "error I2: maplines that branch");
  expectTold(with("(1, 0);", "(1e999, 0);"), "line 5: error I2: this number is too long");
  expectTold("", "error I1: there is no rule in this file");
}

TEST(ImportRls, TellsAllErrorsInOneRun) {
  const std::string all = told(with("(1, 0);", "(1, zero);") + with("quality 1", "qualty 1"));
  EXPECT_NE(all.find("line 5:"), std::string::npos) << all;
  EXPECT_NE(all.find("line 20:"), std::string::npos) << all;
  EXPECT_TRUE(importRls("x.rls", with("(1, 0);", "(1, zero);") + kRule).text.empty());
}

TEST(ImportRls, GivesLikeNamedRulesTitlesOfTheirOwn) {
  const ImportedRules imported = importRls("x.rls", kRule + kRule);
  EXPECT_NE(imported.text.find("rule \"corner, 2\""), std::string::npos);
  EXPECT_TRUE(loadRulesFromText("x.af2", imported.text).rules);
}

TEST(ImportRls, SurvivesGarbage) {
  std::mt19937 random(7);
  const std::string signs = "(){},;\"del0123456789.-+ XY\nrulendqatyfmpos";
  for (int run = 0; run < 3000; ++run) {
    std::string text = kRule;
    for (int change = 0; change < 1 + run % 8; ++change) {
      const std::size_t at = random() % text.size();
      const char sign = signs[random() % signs.size()];
      if (random() % 3 == 0)
        text.erase(at, random() % 10);
      else
        text.replace(at, random() % 2, 1, sign);
    }
    const ImportedRules imported = importRls("x.rls", text);
    EXPECT_EQ(imported.text.empty(), hasErrors(imported.diagnostics)) << text;
  }
}

}  // namespace
}  // namespace af2::dsl
