#include "cli/rules/rule_texts.h"

#include <filesystem>

#include "cli/rules/rules_location.h"
#include "dsl/load/shipped_rules.h"

namespace af2::cli {
namespace {

namespace fs = std::filesystem;

std::string shownFile(const fs::path& file) {
  const fs::path rules = fs::weakly_canonical(rulesDirectory());
  const fs::path inRules = fs::weakly_canonical(file).lexically_relative(rules);
  const bool isInRules = !inRules.empty() && *inRules.begin() != "..";
  return isInRules ? inRules.string() : file.string();
}

}  // namespace

std::vector<geometry::RuleText> ruleTextsOf(const dsl::LoadedRules& loaded) {
  std::vector<geometry::RuleText> texts;
  for (dsl::RuleSource& source : dsl::sourcesOf(loaded))
    texts.push_back({shownFile(source.file), source.line, std::move(source.text)});
  return texts;
}

}  // namespace af2::cli
