// Every code that can be told has a file in which it must be found, and one that comes close and in
// which nothing must be told: codes/found/T1.af2, codes/sound/T1.af2.
//
// In the first, comments name what is to be told of their line, or of the next one ("# next line:
// L3"), or of the file as a whole ("# in the file: N1"). A file of Netgen's rules has its
// expectations beside it, in codes/found/I1.lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

#include "dsl/load/loaded_file.h"
#include "dsl/netgen/rls_import.h"
#include "dsl/proof/match_diagnostics.h"
#include "dsl/run/rule_tests.h"
#include "dsl/text/diagnostic_codes.h"

namespace af2::dsl {
namespace {

namespace fs = std::filesystem;

/// "T1 in line 7"; line 0 is the file as a whole.
using Told = std::set<std::string>;

std::string placed(const std::string& code, int line) {
  return code + " in line " + std::to_string(line);
}

fs::path fileOf(const std::string& folder, const std::string& code) {
  return fs::path(AF2_SOURCE_DIR "/tests/dsl/codes") / folder /
         (code + (code[0] == 'I' ? ".rls" : ".af2"));
}

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Told markedIn(const std::string& text) {
  static const std::regex mark("#\\s+(next line: |in the file: )?([A-Z]\\d+(?: [A-Z]\\d+)*)$");
  Told marked;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch found;
    if (!std::regex_search(line, found, mark)) continue;
    const int place = found[1] == "next line: " ? number + 1 : found[1].length() > 0 ? 0 : number;
    std::istringstream codes(found[2]);
    for (std::string code; codes >> code;) marked.insert(placed(code, place));
  }
  return marked;
}

Told listedIn(const fs::path& path) {
  Told listed;
  std::ifstream file(path);
  int line = 0;
  for (std::string code; file >> code >> line;) listed.insert(placed(code, line));
  return listed;
}

/// All that `af2 check` tells. That other situations are not covered is told of nearly every small
/// file, so it counts only where it is asked for.
std::vector<Diagnostic> checked(const fs::path& path, bool withCoverage) {
  LoadOptions options;
  options.searchPaths = {fs::path(AF2_SOURCE_DIR) / "rules"};
  LoadedRules loaded = loadRules(path, options);
  std::vector<Diagnostic> told = loaded.diagnostics;
  const bool isWhole = loaded.rules != nullptr;
  loaded.rules = loaded.file->soundRules;
  if (!loaded.rules) return told;
  if (isWhole) dropIdleMirrors(loaded, told);
  for (Diagnostic& d : diagnosticsOf(loaded, runSampledChecks(*loaded.rules)))
    if (isWhole || d.code != Code::NeverChosen) addFinding(told, std::move(d));
  if (isWhole && withCoverage)
    for (Diagnostic& d : diagnosticsOf(loaded, measureCoverage(*loaded.rules)))
      addFinding(told, std::move(d));
  return told;
}

std::vector<Diagnostic> toldOf(const fs::path& path, const std::string& code) {
  if (code[0] != 'I') return checked(path, code == "N1" || code == "N2" || code == "C1");
  return importRls(path.filename().string(), contents(path)).diagnostics;
}

class EachCode : public ::testing::TestWithParam<std::string> {};

TEST_P(EachCode, IsFoundWhereItMustBe) {
  const fs::path path = fileOf("found", GetParam());
  ASSERT_TRUE(fs::exists(path)) << path << ": each code needs such a file";
  const bool isRls = GetParam()[0] == 'I';
  const Told wanted =
      isRls ? listedIn(fs::path(path).replace_extension(".lines")) : markedIn(contents(path));
  EXPECT_TRUE(std::ranges::any_of(
      wanted, [&](const std::string& one) { return one.starts_with(GetParam() + " "); }))
      << path << " does not ask for its code";
  const auto diagnostics = toldOf(path, GetParam());
  Told told;
  std::set<std::tuple<Code, int, int>> places;
  for (const Diagnostic& d : diagnostics) {
    told.insert(placed(idOf(d.code), d.place.line));
    EXPECT_TRUE(places.emplace(d.code, d.place.line, d.place.column).second)
        << "told twice of one place: " << toPretty(diagnostics);
  }
  EXPECT_EQ(told, wanted) << toPretty(diagnostics);
}

TEST_P(EachCode, IsNotToldOfWhatComesClose) {
  const fs::path path = fileOf("sound", GetParam());
  ASSERT_TRUE(fs::exists(path)) << path << ": each code needs such a file";
  const auto diagnostics = toldOf(path, GetParam());
  const bool isRls = GetParam()[0] == 'I';
  // Of an imported rule without a twin there is always something to be told.
  for (const Diagnostic& d : diagnostics)
    EXPECT_TRUE(isRls && idOf(d.code) != GetParam()) << toPretty(d);
}

std::vector<std::string> allCodes() {
  std::vector<std::string> codes;
  for (const CodeInfo& info : diagnosticCodes()) codes.emplace_back(info.id);
  return codes;
}

INSTANTIATE_TEST_SUITE_P(All, EachCode, ::testing::ValuesIn(allCodes()),
                         [](const auto& one) { return one.param; });

TEST(Codes, OfTheFilesAreThoseThatAreExplained) {
  for (const char* folder : {"found", "sound"})
    for (const auto& entry :
         fs::directory_iterator(fs::path(AF2_SOURCE_DIR "/tests/dsl/codes") / folder))
      EXPECT_TRUE(findCode(entry.path().stem().string())) << entry.path();
}

/// What is found about matches comes with a test that can be put into the file.
TEST(Codes, OfMatchesComeWithATest) {
  for (const char* code : {"G2", "Z1", "Z2", "Z3", "D3", "N1"}) {
    bool hasTest = false;
    for (const Diagnostic& d : toldOf(fileOf("found", code), code))
      for (const DiagnosticNote& note : d.notes)
        hasTest = hasTest || (idOf(d.code) == code && note.kind == DiagnosticNote::Kind::Test);
    EXPECT_TRUE(hasTest) << code;
  }
}

/// So does a missing mirror image: the test fails, and passes when the rule has its mirror.
TEST(Codes, OfMissingMirrorImagesHaveAnExample) {
  const fs::path path = fileOf("found", "M1");
  const LoadedRules loaded = loadRules(path);
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  std::string text = contents(path);
  std::size_t count = 0;
  for (const Diagnostic& d : loaded.diagnostics) {
    const auto example = mirrorExampleOf(loaded, d);
    ASSERT_TRUE(example) << toPretty(d);
    text += example->test;
    ++count;
  }
  EXPECT_EQ(count, 3u);
  const auto failures = [](const std::string& file) {
    const LoadedRules again = loadRulesFromText("with tests.af2", file);
    EXPECT_TRUE(again.rules) << toPretty(again.diagnostics);
    std::set<std::string> failed;
    for (const TestResult& result : runRuleTests(again))
      if (!result.passed()) failed.insert(result.title.substr(0, result.title.find(':')));
    return failed;
  };
  EXPECT_EQ(failures(text), (Told{"right only", "wide", "wide, by hand"})) << text;
  const std::string end = "  tri   a b c;\n";
  text.insert(text.find(end) + end.size(), "  mirror \"left only\";\n");
  EXPECT_EQ(failures(text), (Told{"wide", "wide, by hand"})) << text;
}

}  // namespace
}  // namespace af2::dsl
