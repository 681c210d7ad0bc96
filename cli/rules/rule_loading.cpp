#include "cli/rules/rule_loading.h"

#include <fmt/core.h>

#include <algorithm>

#include "cli/program/colour.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rule_findings.h"
#include "cli/rules/rules_location.h"
#include "dsl/load/rule_file.h"
#include "dsl/load/shipped_rules.h"
#include "dsl/text/diagnostic_codes.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

std::size_t errorCount(const std::vector<dsl::Diagnostic>& diagnostics) {
  return static_cast<std::size_t>(
      std::ranges::count(diagnostics, dsl::Severity::Error, &dsl::Diagnostic::severity));
}

/// Those that a rule file may allow: the rules can be run all the same.
std::vector<dsl::Code> allowableErrors() {
  std::vector<dsl::Code> codes;
  for (const dsl::CodeInfo& info : dsl::diagnosticCodes())
    if (info.allowance == dsl::Allowance::AsError) codes.push_back(info.code);
  return codes;
}

/// Errors in full; of warnings, how many there are.
void print(std::vector<dsl::Diagnostic> diagnostics, const std::string& file, bool isQuiet) {
  const std::size_t warnings = diagnostics.size() - errorCount(diagnostics);
  std::erase_if(diagnostics,
                [](const dsl::Diagnostic& d) { return d.severity != dsl::Severity::Error; });
  fmt::print(stderr, "{}", dsl::toPretty(diagnostics, colourOf(stderr)));
  if (warnings > 0 && !isQuiet)
    fmt::print(stderr, "af2: {} warning{} about the rules; 'af2 check {}' shows {}\n", warnings,
               warnings == 1 ? "" : "s", file, warnings == 1 ? "it" : "them");
}

[[noreturn]] void refuse(std::size_t errors, const std::string& file, const char* wayOut) {
  throw InputError(fmt::format("{} error{} in the rule file '{}', see above{}", errors,
                               errors == 1 ? "" : "s", file, wayOut));
}

}  // namespace

dsl::LoadedRules loadRuleSet(const std::filesystem::path& file, const RuleLoading& loading) {
  dsl::LoadOptions options;
  const dsl::Registry registry = loadPlugins(loading.plugins);
  options.searchPaths = {rulesDirectory()};
  options.registry = &registry;
  if (loading.isUnchecked) options.allowed = allowableErrors();
  dsl::LoadedRules loaded = dsl::loadRules(file, options);
  const std::string name = file.string();
  print(loaded.diagnostics, name, loading.isQuiet);
  if (!loaded.rules) refuse(errorCount(loaded.diagnostics), name, "");
  if (loading.isUnchecked || dsl::isShipped(loaded)) return loaded;

  const RuleFindings findings = provenErrorsIn(loaded);
  print(findings.diagnostics, name, loading.isQuiet);
  if (!findings.diagnostics.empty())
    refuse(findings.diagnostics.size(), name, "; --unchecked runs the rules all the same");
  if (findings.sampled > 0 && !loading.isQuiet)
    fmt::print(stderr,
               "af2: {} of {} rules are not proven to be sound, only tried on random matches; "
               "'af2 check --prove {}' takes its time\n",
               findings.sampled, findings.ruleCount, name);
  return loaded;
}

}  // namespace af2::cli
