#include "cli/rules/rule_loading.h"

#include <fmt/core.h>

#include <algorithm>

#include "cli/program/colour.h"
#include "cli/rules/rules_location.h"
#include "dsl/load/rule_file.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

bool isError(const dsl::Diagnostic& diagnostic) {
  return diagnostic.severity == dsl::Severity::Error;
}

}  // namespace

std::shared_ptr<const RuleSet> loadRuleSet(const std::filesystem::path& file) {
  dsl::LoadOptions options;
  options.searchPaths = {rulesDirectory()};
  const dsl::LoadedRules loaded = dsl::loadRules(file, options);
  fmt::print(stderr, "{}", dsl::toPretty(loaded.diagnostics, colourOf(stderr)));
  const auto errors = std::ranges::count_if(loaded.diagnostics, isError);
  if (loaded.rules) return loaded.rules;
  throw InputError(fmt::format("{} error{} in the rule file '{}', see above", errors,
                               errors == 1 ? "" : "s", file.string()));
}

}  // namespace af2::cli
