// Rule files with what the checks over all matches must find in them, and nothing else.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "dsl/load/loaded_file.h"
#include "dsl/netgen/rls_import.h"
#include "dsl/proof/match_diagnostics.h"
#include "dsl/run/rule_tests.h"
#include "tests/dsl/netgen/linear_sums.h"

namespace af2::dsl {
namespace {

/// The lines "# finds CODE: rule" at the head of a file; of G2 and Z1 it says which are warnings.
std::set<std::string> expectedIn(const std::filesystem::path& path) {
  std::set<std::string> expected;
  std::ifstream file(path);
  const std::string mark = "# finds ";
  for (std::string line; std::getline(file, line);)
    if (line.rfind(mark, 0) == 0) expected.insert(line.substr(mark.size()));
  return expected;
}

std::string described(const Diagnostic& d) {
  const bool mayBeEither = d.code == Code::InvertibleElement || d.code == Code::UncoveredElement;
  const bool isWarning = mayBeEither && d.severity == Severity::Warning;
  return idOf(d.code) + (isWarning ? " (warning): " : ": ") + d.rule;
}

std::vector<Diagnostic> diagnose(const std::filesystem::path& path) {
  const LoadedRules loaded = loadRules(path);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  if (!loaded.rules) return {};
  return diagnosticsOf(loaded, runSampledChecks(*loaded.rules));
}

class RuleFile : public ::testing::TestWithParam<std::string> {};

TEST_P(RuleFile, HasJustTheseFindings) {
  const auto path = std::filesystem::path(AF2_SOURCE_DIR "/tests/dsl/proof/cases") / GetParam();
  const auto diagnostics = diagnose(path);
  std::set<std::string> found;
  for (const Diagnostic& d : diagnostics) found.insert(described(d));
  EXPECT_EQ(found, expectedIn(path)) << toPretty(diagnostics);
}

INSTANTIATE_TEST_SUITE_P(Cases, RuleFile,
                         ::testing::Values("quads.af2", "inverted.af2", "covered.af2",
                                           "growing.af2", "shadowed.af2", "lost.af2", "later.af2",
                                           "conditions.af2"),
                         [](const auto& one) { return one.param.substr(0, one.param.find('.')); });

TEST(LaterLevels, AreNamedByTheLowestOneWithAFault) {
  for (const Diagnostic& d :
       diagnose(std::filesystem::path(AF2_SOURCE_DIR "/tests/dsl/proof/cases") / "later.af2")) {
    const std::string end = d.rule == "turns over later"    ? "; no fault was found below level 2"
                            : d.rule == "loosens by itself" ? "; no fault was found below level 2"
                            : d.rule == "sticks out later"  ? "; no fault was found below level 3"
                            : d.rule == "moves once"        ? "; no fault was found below level 30"
                                                            : "";
    EXPECT_TRUE(d.message.ends_with(end)) << d.message;
    EXPECT_EQ(d.message.find("; no fault was found below") == std::string::npos, end.empty())
        << d.message;
  }
}

TEST(ClassicTriangles, AreProvenButForLostMatches) {
  const LoadedRules loaded = loadRules(AF2_SOURCE_DIR "/rules/tri/classic.af2");
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  const SampledResult result = runSampledChecks(*loaded.rules);
  for (std::size_t i = 0; i < result.answers.size(); ++i) {
    EXPECT_EQ(result.answers[i].positive, Answer::Proven) << loaded.rules->rules()[i].name();
    EXPECT_EQ(result.answers[i].covered, Answer::Proven) << loaded.rules->rules()[i].name();
  }
  const auto diagnostics = diagnosticsOf(loaded, result);
  ASSERT_EQ(diagnostics.size(), 1u) << toPretty(diagnostics);
  EXPECT_EQ(idOf(diagnostics[0].code), "Z2");
  EXPECT_EQ(diagnostics[0].rule, "2 h vis a vis");
  EXPECT_NE(diagnostics[0].place.text.find("zone"), std::string::npos);
  ASSERT_EQ(diagnostics[0].notes.size(), 1u);
  EXPECT_EQ(diagnostics[0].notes[0].message.rfind("test \"2 h vis a vis", 0), 0u);
}

TEST(PavingQuads, LieInTheirZones) {
  const LoadedRules loaded = loadRules(AF2_SOURCE_DIR "/rules/quad/paving.af2");
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  const SampledResult result = runSampledChecks(*loaded.rules);
  EXPECT_TRUE(result.findings.empty());
  for (std::size_t i = 0; i < result.answers.size(); ++i) {
    const AF2Rule& rule = loaded.rules->rules()[i];
    EXPECT_EQ(result.answers[i].positive, Answer::NotAsked) << rule.name();
    EXPECT_EQ(result.answers[i].covered, rule.definition().path ? Answer::NotAsked : Answer::Proven)
        << rule.name();
  }
}

/// What the checks write, put into the rule file, is read, and fails there: it shows the fault.
void expectTestsThatFail(const LoadedRules& loaded, std::vector<SampledFinding> findings) {
  std::string text(loaded.file->main().source.text());
  if (const auto uncovered = findUncoveredSituations(measureCoverage(*loaded.rules)))
    findings.push_back(*uncovered);
  std::size_t own = loaded.file->tests.size(), added = 0;
  const auto add = [&](const std::string& test) {
    text += test;
    ++added;
  };
  for (const SampledFinding& finding : findings) {
    // That a condition always holds no match can show.
    if (finding.code == Code::IdleClause && finding.test.empty()) continue;
    EXPECT_FALSE(finding.test.empty());
    add(finding.test);
    for (const std::string& test : finding.furtherTests) add(test);
  }
  const LoadedRules again = loadRulesFromText("with tests.af2", text);
  ASSERT_TRUE(again.rules) << toPretty(again.diagnostics);
  const auto results = runRuleTests(again);
  ASSERT_GE(results.size(), own + added);
  for (std::size_t i = own; i < own + added; ++i)
    EXPECT_FALSE(results[i].passed()) << results[i].title;
}

TEST_P(RuleFile, GivesTestsThatFailUntilItIsMended) {
  const LoadedRules loaded =
      loadRules(std::filesystem::path(AF2_SOURCE_DIR "/tests/dsl/proof/cases") / GetParam());
  ASSERT_TRUE(loaded.rules);
  expectTestsThatFail(loaded, runSampledChecks(*loaded.rules).findings);
}

TEST(RuleFiles, ThatComeWithAf2GiveTestsThatFail) {
  for (const char* name : {"/rules/tri/classic.af2", "/rules/quad/classic.af2"}) {
    const LoadedRules loaded = loadRules(std::string(AF2_SOURCE_DIR) + name);
    ASSERT_TRUE(loaded.rules);
    expectTestsThatFail(loaded, runSampledChecks(*loaded.rules).findings);
  }
}

// ---- the classical files, imported
// ---------------------------------------------------------------

LoadedRules imported(std::span<const RuleNumbers> rules) {
  std::string text;
  for (const RuleNumbers& rule : rules) text += rlsText(rule);
  return loadRulesFromText("imported.af2", importRls("classic.rls", text).text);
}

/// "CODE: rule" of all that is told after the import.
std::map<std::string, std::string> toldOf(const LoadedRules& loaded, const SampledResult& result) {
  std::map<std::string, std::string> told;
  for (const auto& all : {loaded.diagnostics, diagnosticsOf(loaded, result)})
    for (const Diagnostic& d : all)
      told[idOf(d.code) + ": " + d.rule] += d.message + d.label + d.help;
  return told;
}

TEST(ImportedQuads, HaveTheFaultsThatTheyAreKnownFor) {
  const LoadedRules loaded = imported(kQuads);
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  const SampledResult result = runSampledChecks(*loaded.rules);
  const auto told = toldOf(loaded, result);
  for (const char* fault :
       {"T1: Left 120 (1)", "G1: Left 120 (1)", "Z1: Quad P Right (150)", "Z1: Left P Quad (150)",
        "G2: Quad P Right (150)", "G2: Left P Quad (150)", "Z2: Two left (1)", "Z2: Two Right (1)",
        "Z2: Left Right (1)", "Z2: Right 60 (1)", "M1: Right 60 (1)", "M1: Quad Right (1)",
        "M1: Quad P Right (2)", "M1: 2 h Vis A Vis (1)", "D2: Right 120 (1)", "D2: Left 120 (1)",
        "D2: 2 h Vis A Vis (1)"})
    EXPECT_TRUE(told.contains(fault)) << fault;
  EXPECT_NE(told.at("T1: Left 120 (1)").find("`a d c`"), std::string::npos);
  EXPECT_NE(told.at("M1: Quad Right (1)").find("Left Quad (1)"), std::string::npos);
  EXPECT_NE(told.at("M1: Quad Right (1)").find("new vertices by up to"), std::string::npos);
  EXPECT_NE(told.at("M1: Quad P Right (2)").find("Left P Quad (2)"), std::string::npos);
  EXPECT_NE(told.at("M1: Quad P Right (2)").find("free zones by up to"), std::string::npos);
  EXPECT_NE(told.at("M1: 2 h Vis A Vis (1)").find("not quite its own mirror image"),
            std::string::npos);
  for (std::size_t i = 0; i < result.answers.size(); ++i) {
    const std::string& name = loaded.rules->rules()[i].name();
    const double lost = result.answers[i].lostMatches;
    const bool isOpen =
        name == "Two left (1)" || name == "Two Right (1)" || name == "Left Right (1)";
    if (isOpen) {
      EXPECT_NEAR(lost, 0.26, 0.04) << name;
    }
    if (name == "Right 60 (1)") {
      EXPECT_NEAR(lost, 0.24, 0.03);
    }
  }
}

TEST(ImportedQuads, AreSoundInTheRest) {
  const LoadedRules loaded = imported(kQuads);
  ASSERT_TRUE(loaded.rules);
  const SampledResult result = runSampledChecks(*loaded.rules);
  for (const SampledFinding& finding : result.findings) {
    const std::string& name = loaded.rules->rules()[finding.rule].name();
    EXPECT_NE(idOf(finding.code), "D3") << name;
    if (finding.code == Code::UncoveredElement || finding.code == Code::GrowingZone) {
      EXPECT_NE(name.find("(150)"), std::string::npos) << name;
    }
  }
  expectTestsThatFail(loaded, result.findings);
}

TEST(ImportedTriangles, LoseMatchesOfOneRuleAndNothingElse) {
  const LoadedRules loaded = imported(kTriangles);
  ASSERT_TRUE(loaded.rules);
  const SampledResult result = runSampledChecks(*loaded.rules);
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_EQ(idOf(result.findings[0].code), "Z2");
  EXPECT_NEAR(result.answers[11].lostMatches, 0.3, 0.03);
  EXPECT_FALSE(findUncoveredSituations(measureCoverage(*loaded.rules)));
}

}  // namespace
}  // namespace af2::dsl
