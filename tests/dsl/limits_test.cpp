// Inputs of any size end in an answer, soon and in bounded memory.
#include <gtest/gtest.h>

#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "dsl/rule_file.h"

namespace af2::dsl {
namespace {

namespace fs = std::filesystem;

const std::string kHead = "af2 1;\nruleset \"s\" { elements tri; }\n";

std::string ruleOf(int number) {
  return "rule \"r" + std::to_string(number) +
         "\" quality 1 { new c = mid(a, b) + (0, 0.8); zone a, b, c; tri a b c; }\n";
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

std::string firstCode(const std::string& text) {
  const auto found = loadRulesFromText("x.af2", text).diagnostics;
  return found.empty() ? "none" : found.front().code;
}

TEST(Limits, EndWhatIsTooLong) {
  EXPECT_EQ(firstCode(kHead + repeated(" c", 500'000)), "S6") << "words";
  EXPECT_EQ(firstCode(kHead + std::string(9u << 20, '#')), "S6") << "bytes";
  EXPECT_EQ(firstCode(kHead + repeated("{}", 100'000)), "S1") << "faults";
  std::string family = "rule \"f {k}\" for (k) in (1)";
  for (int k = 2; k < 6000; ++k) family += ", (" + std::to_string(k) + ")";
  family += " quality 1 { new c = mid(a, b) + (0, 0.8); zone a, b, c; tri a b c; }";
  EXPECT_EQ(firstCode(kHead + family), "S6") << "members of a family";
}

TEST(Limits, AFindingOnALongLineHoldsALittleOfIt) {
  const std::string long_line = kHead + repeated("const c = 1; ", 20'000) + "const d = ;";
  for (const Diagnostic& d : loadRulesFromText("x.af2", long_line).diagnostics) {
    EXPECT_LE(d.place.text.size(), 4000u);
    EXPECT_NE(toPretty(d).find(d.code == "R2" ? " ^\n" : "^"), std::string::npos) << toPretty(d);
  }
}

TEST(Limits, AnErrorPushesOutAWarning) {
  std::string text = kHead + ruleOf(0) + "rule \"x\" quality 1 {\n";
  for (int i = 0; i < 400; ++i) text += "  require " + std::to_string(i) + " < 1000;\n";
  text += "  new c = nothing;\n  zone a, b, c;\n  tri a b c;\n}\n";
  const LoadedRules loaded = loadRulesFromText("x.af2", text);
  EXPECT_EQ(loaded.rules, nullptr);
  EXPECT_TRUE(hasErrors(loaded.diagnostics));
}

class ImportLimits : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("af2-limits-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  LoadedRules load(const std::string& name) const { return loadRules(folder_ / name); }

  fs::path folder_;
};

TEST_F(ImportLimits, DiamondsUseEachFileOnce) {
  constexpr int kDepth = 30;  // 2^30 ways from the first file to the last
  for (int i = 0; i < kDepth; ++i) {
    const std::string next = "d" + std::to_string(i + 1) + ".af2";
    std::string text = i == 0 ? kHead : "af2 1;\n";
    if (i + 1 < kDepth)
      text += "import \"" + next + "\" as l;\nimport \"" + next + "\" as r;\nuse l.*;\nuse r.*;\n";
    write("d" + std::to_string(i) + ".af2", text + ruleOf(i));
  }
  const LoadedRules loaded = load("d0.af2");
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  EXPECT_EQ(loaded.rules->rules().size(), static_cast<std::size_t>(kDepth));
}

TEST_F(ImportLimits, DevicesAreNotImported) {
  write("x.af2",
        "af2 1;\nimport \"/dev/zero\" as z;\nruleset \"s\" { elements tri; }\n" + ruleOf(0));
  const LoadedRules loaded = load("x.af2");
  ASSERT_EQ(loaded.diagnostics.size(), 1u);
  EXPECT_EQ(loaded.diagnostics[0].message, "cannot import \"/dev/zero\": it is no ordinary file");
}

#if !defined(__SANITIZE_ADDRESS__)
/// The classical rules, each many times under new titles.
TEST(Limits, TwoHundredRulesAreReadAndCheckedInAFifthOfASecond) {
  std::ifstream file(AF2_SOURCE_DIR "/rules/tri/classic.af2");
  std::stringstream classic;
  classic << file.rdbuf();
  std::string text = classic.str();
  const std::size_t first = text.find("rule \""), last = text.find("test \"");
  ASSERT_LT(first, last);
  const std::string rules = text.substr(first, last - first);
  for (int copy = 2; copy <= 20; ++copy) {
    std::istringstream lines(rules);
    for (std::string line; std::getline(lines, line);) {
      for (const std::string& word : {std::string("rule \""), std::string("mirror \"")})
        if (const auto at = line.find(word); at != line.npos)
          line.insert(at + word.size(), "copy " + std::to_string(copy) + " of ");
      text += line + "\n";
    }
  }
  double best = 1e9;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const std::clock_t begin = std::clock();
    const LoadedRules loaded = loadRulesFromText("x.af2", text);
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
    ASSERT_GE(loaded.rules->rules().size(), 200u);
  }
  RecordProperty("milliseconds", static_cast<int>(best * 1000));
  EXPECT_LT(best, 0.2);
}
#endif

}  // namespace
}  // namespace af2::dsl
