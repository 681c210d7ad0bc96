// Golden cases: every file of cases/ gives exactly the text of its .expected file.
// AF2_UPDATE_CASES=1 in the environment writes them anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "dsl/load/rule_file.h"

namespace af2::dsl {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> caseNames() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(AF2_SOURCE_DIR "/tests/dsl/cases"))
    if (entry.path().extension() == ".af2" && !entry.path().stem().string().starts_with("lib_"))
      names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class Cases : public testing::TestWithParam<std::string> {};

TEST_P(Cases, AreToldAsExpected) {
  const fs::path folder(AF2_SOURCE_DIR "/tests/dsl/cases"),
      expected = folder / (GetParam() + ".expected");
  const fs::path before = fs::current_path();
  fs::current_path(folder);  // so that paths in messages are the same everywhere
  const LoadedRules loaded = loadRules(GetParam() + ".af2");
  fs::current_path(before);
  const std::string told = toPretty(loaded.diagnostics);
  if (std::getenv("AF2_UPDATE_CASES")) std::ofstream(expected) << told;
  EXPECT_EQ(told, contents(expected));
}

INSTANTIATE_TEST_SUITE_P(Golden, Cases, testing::ValuesIn(caseNames()),
                         [](const auto& tested) { return tested.param; });

TEST(Diagnostics, AreWrittenForPeopleAndMachines) {
  const LoadedRules loaded = loadRulesFromText("x.af2", "af2 1;\nconst H = ;\nruleset \"s\" {}\n");
  ASSERT_GE(loaded.diagnostics.size(), 1u);
  EXPECT_EQ(toPretty(loaded.diagnostics[0]),
            "error[AF2-S3]: an expression is missing between '=' and ';'\n"
            " --> x.af2:2:11\n"
            "  |\n"
            "2 | const H = ;\n"
            "  |           ^\n"
            "  = help: write a number, a point, a name, ...\n");
  EXPECT_EQ(toGcc({&loaded.diagnostics[0], 1}),
            "x.af2:2:11: error: an expression is missing between '=' and ';' [AF2-S3]\n");
  EXPECT_NE(toJson(loaded.diagnostics).find("\"end_column\": 12"), std::string::npos)
      << toJson(loaded.diagnostics);
  EXPECT_NE(toSarif(loaded.diagnostics).find("\"ruleId\": \"AF2-S3\""), std::string::npos);
}

TEST(Diagnostics, InJsonHaveTheKeysThatAreDocumentedAndNoOthers) {
  const std::string json =
      toJson(loadRulesFromText("x.af2", "af2 1;\nrule \"r\" quality 1.5 {}\n").diagnostics);
  std::vector<std::string> keys;
  for (std::size_t at = json.find("    \""); at != json.npos; at = json.find("    \"", at + 5))
    if (const auto end = json.find("\": ", at); end < json.find('\n', at))
      keys.push_back(json.substr(at + 5, end - at - 5));
  keys.resize(10);
  EXPECT_EQ(keys, (std::vector<std::string>{"file", "line", "column", "end_line", "end_column",
                                            "severity", "code", "message", "notes", "help"}))
      << json;
  EXPECT_NE(json.find("\"this is 1.5\""), std::string::npos) << "the words beside the caret";
}

TEST(Diagnostics, InSarifHaveAddressesAndRelatedPlaces) {
  const LoadedRules loaded = loadRulesFromText(
      "my rules/gr\u00FCn.af2", "af2 1;\nconst H = 1;\nconst H = 2;\nruleset \"s\" {}\n");
  const std::string sarif = toSarif(loaded.diagnostics);
  EXPECT_NE(sarif.find("\"uri\": \"my%20rules/gr%C3%BCn.af2\""), std::string::npos) << sarif;
  EXPECT_NE(sarif.find("\"relatedLocations\""), std::string::npos);
  EXPECT_NE(sarif.find("\"columnKind\": \"unicodeCodePoints\""), std::string::npos);
  const LoadedRules missing = loadRules("there is no such file.af2");
  EXPECT_EQ(toSarif(missing.diagnostics).find("\"region\""), std::string::npos) << "no place";
}

TEST(Diagnostics, BringTheirEditsAlong) {
  const LoadedRules loaded =
      loadRulesFromText("x.af2", "af2 1;\nruleset \"s\" {}\nconst H = 1;\nconst K = 2 * h + 0;\n");
  ASSERT_EQ(loaded.diagnostics[0].edits.size(), 1u) << toPretty(loaded.diagnostics);
  const SuggestedEdit& edit = loaded.diagnostics[0].edits[0];
  EXPECT_EQ(edit.replacement, "H");
  EXPECT_EQ(edit.what, "'h' becomes 'H'");
  EXPECT_EQ(std::pair(edit.place.line, edit.place.column), std::pair(4, 15));
  EXPECT_EQ(std::pair(edit.place.endLine, edit.place.endColumn), std::pair(4, 16));
  const std::string sarif = toSarif(loaded.diagnostics);
  for (const char* part : {"\"fixes\"", "\"artifactChanges\"", "\"deletedRegion\"",
                           "\"startColumn\": 15", "\"insertedContent\"", "\"text\": \"H\""})
    EXPECT_NE(sarif.find(part), std::string::npos) << part << sarif;
}

TEST(Diagnostics, AreColouredOnATerminalAndSayTheSame) {
  const LoadedRules loaded = loadRulesFromText("x.af2", "af2 1;\nconst H = 1;\nconst H = ;\n");
  std::string coloured = toPretty(loaded.diagnostics, Colour::Terminal);
  EXPECT_NE(coloured.find("\x1b[1;31merror"), std::string::npos);
  for (std::size_t at; (at = coloured.find('\x1b')) != coloured.npos;)
    coloured.erase(at, coloured.find('m', at) - at + 1);
  EXPECT_EQ(coloured, toPretty(loaded.diagnostics));
}

TEST(Diagnostics, AreAtMostFifty) {
  std::string text = "af2 1;\nruleset \"s\" {}\n";
  for (int i = 0; i < 200; ++i)
    text += "const c" + std::to_string(i) + " = nothing" + std::to_string(i) + ";\n";
  const LoadedRules loaded = loadRulesFromText("x.af2", text);
  EXPECT_EQ(loaded.diagnostics.size(), 50u);
  EXPECT_EQ(loaded.diagnostics[0].place.line, 3);
}

}  // namespace
}  // namespace af2::dsl
