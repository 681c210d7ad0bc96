#include "dsl/load/shipped_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "dsl/load/rule_file.h"
#include "engine/base/error.h"

namespace af2::dsl {
namespace {

TEST(ShippedRules, AreThoseOfTheFiles) {
  EXPECT_GE(shippedFiles().size(), 5u);
  for (const ShippedFile& file : shippedFiles()) {
    const LoadedRules loaded = loadRules(AF2_SOURCE_DIR "/rules/" + std::string(file.name));
    ASSERT_TRUE(loaded.rules) << file.name;
    const auto shipped = shippedRules(file.name);
    EXPECT_EQ(shipped->name(), loaded.rules->name());
    EXPECT_EQ(shipped->rules().size(), loaded.rules->rules().size());
  }
}

TEST(ShippedRules, AreTheDefaultOnesUnlessNamed) {
  EXPECT_EQ(defaultRules()->name(), "even triangles");
  EXPECT_EQ(shippedRules("quad/paving.af2")->name(), "paving");
}

TEST(ShippedRules, NameWhatThereIsInstead) {
  try {
    shippedRules("tri/evn.af2");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("tri/even.af2"), std::string::npos) << error.what();
  }
  EXPECT_THROW(shippedRules("../tri/even"), InputError);
}

TEST(ShippedRules, AreNotEditedFiles) {
  EXPECT_TRUE(isShipped(loadShippedRules("tri/even.af2")));
  EXPECT_TRUE(isShipped(loadRules(AF2_SOURCE_DIR "/rules/tri/even.af2")));
  const std::string edited(
      std::ranges::find(shippedFiles(), "tri/classic.af2", &ShippedFile::name)->text);
  EXPECT_FALSE(isShipped(loadRulesFromText("classic.af2", edited + "\n# mine\n")));
}

TEST(ShippedRules, AreImportedByRulesOfPrograms) {
  const std::string text = R"(af2 1;
import "tri/classic.af2" as classic;
use classic.*;
ruleset "mine" extends "classic triangles" {}
)";
  EXPECT_FALSE(loadRulesFromText("mine.af2", text).rules);
  const LoadedRules loaded = loadRulesFromText("mine.af2", text, withShippedImports({}));
  ASSERT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  EXPECT_EQ(loaded.rules->rules().size(), shippedRules("tri/classic.af2")->rules().size());
  EXPECT_FALSE(isShipped(loaded));
}

TEST(ShippedRules, GiveWayToFilesOfPrograms) {
  LoadOptions options;
  options.searchPaths = {"/here"};
  options.needsRuleSet = false;
  options.unsaved = [](const std::filesystem::path& path) -> std::optional<std::string> {
    if (path != "/here/tri/classic.af2") return std::nullopt;
    return "af2 1;\nconst five = 5;\n";
  };
  const std::string text = R"(af2 1;
import "tri/classic.af2" as own;
const ten = 2 * own.five;
)";
  const LoadedRules loaded = loadRulesFromText("mine.af2", text, withShippedImports(options));
  EXPECT_FALSE(hasErrors(loaded.diagnostics)) << toPretty(loaded.diagnostics);
}

TEST(ShippedRules, SayWhereTheyAreWritten) {
  const LoadedRules loaded = loadShippedRules("tri/classic.af2");
  const std::vector<RuleSource> sources = sourcesOf(loaded);
  ASSERT_EQ(sources.size(), loaded.rules->rules().size());
  const auto onDisk = sourcesOf(loadRules(AF2_SOURCE_DIR "/rules/tri/classic.af2"));
  for (std::size_t i = 0; i < sources.size(); ++i) {
    EXPECT_EQ(sources[i].file, "tri/classic.af2");
    EXPECT_EQ(sources[i].line, onDisk[i].line);
    EXPECT_EQ(sources[i].text, onDisk[i].text);
    EXPECT_EQ(sources[i].text.back(), '}');
  }
  EXPECT_EQ(onDisk.front().file, AF2_SOURCE_DIR "/rules/tri/classic.af2");
}

}  // namespace
}  // namespace af2::dsl
