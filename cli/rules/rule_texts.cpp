#include "cli/rules/rule_texts.h"

#include <filesystem>

#include "cli/rules/rules_location.h"
#include "dsl/load/loaded_file.h"

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
  const std::vector<dsl::CompiledRule>& rules = loaded.file->rules;
  for (std::size_t i = 0; i < loaded.rules->rules().size(); ++i) {
    const dsl::SourceText& source = rules[i].home->source;
    const dsl::Span span = rules[i].text->span;
    texts.push_back({shownFile(source.name()), source.lineOf(span.begin),
                     std::string(source.text().substr(span.begin, span.end - span.begin))});
  }
  return texts;
}

}  // namespace af2::cli
