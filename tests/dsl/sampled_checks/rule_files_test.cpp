// Rule files with what the checks over all matches must find in them, and nothing else.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "dsl/checks/match_diagnostics.h"

namespace af2::dsl {
namespace {

/// The lines "# finds CODE: rule" at the head of a file.
std::set<std::string> expectedIn(const std::filesystem::path& path) {
  std::set<std::string> expected;
  std::ifstream file(path);
  const std::string mark = "# finds ";
  for (std::string line; std::getline(file, line);)
    if (line.rfind(mark, 0) == 0) expected.insert(line.substr(mark.size()));
  return expected;
}

std::vector<Diagnostic> diagnose(const std::filesystem::path& path) {
  const LoadedRules loaded = loadRules(path);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  if (!loaded.rules) return {};
  return diagnosticsOf(loaded, runSampledChecks(*loaded.rules));
}

class RuleFile : public ::testing::TestWithParam<std::string> {};

TEST_P(RuleFile, HasJustTheseFindings) {
  const auto path = std::filesystem::path(AF2_CASES_DIR) / GetParam();
  const auto diagnostics = diagnose(path);
  std::set<std::string> found;
  for (const Diagnostic& d : diagnostics) found.insert(d.code + ": " + d.rule);
  EXPECT_EQ(found, expectedIn(path)) << toPretty(diagnostics);
}

INSTANTIATE_TEST_SUITE_P(Cases, RuleFile,
                         ::testing::Values("quads.af2", "inverted.af2", "covered.af2",
                                           "growing.af2", "shadowed.af2", "lost.af2"),
                         [](const auto& one) { return one.param.substr(0, one.param.find('.')); });

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
  EXPECT_EQ(diagnostics[0].code, "Z2");
  EXPECT_EQ(diagnostics[0].rule, "2 h vis a vis");
  EXPECT_NE(diagnostics[0].place.text.find("zone"), std::string::npos);
  ASSERT_EQ(diagnostics[0].notes.size(), 1u);
  EXPECT_EQ(diagnostics[0].notes[0].message.rfind("test \"2 h vis a vis", 0), 0u);
}

/// What the checks write can be read again.
TEST(Findings, ComeWithTestsThatCanBeRead) {
  const LoadedRules loaded = loadRules(std::filesystem::path(AF2_CASES_DIR) / "quads.af2");
  ASSERT_TRUE(loaded.rules);
  std::string text(loaded.file->main().source.text());
  for (const SampledFinding& finding : runSampledChecks(*loaded.rules).findings) {
    EXPECT_FALSE(finding.test.empty()) << finding.message;
    text += finding.test;
  }
  const LoadedRules again = loadRulesFromText("with tests.af2", text);
  EXPECT_TRUE(again.rules) << toPretty(again.diagnostics);
}

}  // namespace
}  // namespace af2::dsl
