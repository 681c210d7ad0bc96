#include "cli/rules/rule_texts.h"

#include <filesystem>
#include <map>

#include "cli/rules/rules_location.h"
#include "dsl/load/shipped_rules.h"

namespace af2::cli {
namespace {

namespace fs = std::filesystem;

/// Names of files, of which the shipped ones begin within the folder of the rules.
class ShownFiles {
 public:
  const std::string& nameOf(const std::string& file) {
    const auto [name, isNew] = names_.try_emplace(file);
    if (isNew) name->second = shown(file);
    return name->second;
  }

 private:
  std::string shown(const fs::path& file) const {
    const fs::path inRules = fs::weakly_canonical(file).lexically_relative(rules_);
    const bool isInRules = !inRules.empty() && *inRules.begin() != "..";
    return isInRules ? inRules.string() : file.string();
  }

  fs::path rules_ = fs::weakly_canonical(rulesDirectory());
  std::map<std::string, std::string> names_;
};

}  // namespace

std::vector<geometry::RuleText> ruleTextsOf(const dsl::LoadedRules& loaded) {
  ShownFiles shown;
  std::vector<geometry::RuleText> texts;
  for (dsl::RuleSource& source : dsl::sourcesOf(loaded))
    texts.push_back({shown.nameOf(source.file), source.line, std::move(source.text)});
  return texts;
}

}  // namespace af2::cli
