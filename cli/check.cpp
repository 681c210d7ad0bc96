// af2 check
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/exit_code.h"
#include "cli/rule_files.h"
#include "cli/rule_findings.h"
#include "cli/verbs.h"
#include "dsl/code_explanations.h"

namespace af2::cli {
namespace {

using dsl::Diagnostic;

struct CheckOptions {
  std::vector<std::string> files;
  std::string format = "pretty";
  FindingOptions findings;
  bool strict = false, quiet = false;
};

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string proofText(const RuleFindings& all) {
  if (all.proven + all.sampled == 0) return {};
  if (all.sampled == 0) return " (G2 and Z1 proven)";
  return fmt::format(" (G2 and Z1 proven for {}, tried on samples for {})",
                     counted(all.proven, "rule"), all.sampled);
}

std::size_t countOf(const std::vector<Diagnostic>& diagnostics, dsl::Severity severity) {
  return static_cast<std::size_t>(std::ranges::count(diagnostics, severity, &Diagnostic::severity));
}

std::string summaryOf(const CheckOptions& options, const RuleFindings& all) {
  std::string files;
  if (options.files.size() > 1) files = counted(options.files.size(), "file") + ", ";
  return fmt::format("{}{}: {}, {}{}\n", files, counted(all.ruleCount, "rule"),
                     counted(countOf(all.diagnostics, dsl::Severity::Error), "error"),
                     counted(countOf(all.diagnostics, dsl::Severity::Warning), "warning"),
                     proofText(all));
}

void tell(const CheckOptions& options, const RuleFindings& all) {
  if (options.format == "json") return fmt::print("{}", dsl::toJson(all.diagnostics));
  if (options.format == "sarif") return fmt::print("{}", dsl::toSarif(all.diagnostics));
  if (options.format == "gcc") return fmt::print("{}", dsl::toGcc(all.diagnostics));
  fmt::print("{}", dsl::toPretty(all.diagnostics));
  if (!options.quiet) fmt::print("{}", summaryOf(options, all));
}

/// A file that several others import is told about once.
void append(std::vector<Diagnostic>& all, std::vector<Diagnostic> more) {
  const std::size_t known = all.size();
  for (Diagnostic& diagnostic : more) {
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(known);
    if (std::find(all.begin(), end, diagnostic) == end) all.push_back(std::move(diagnostic));
  }
}

int check(CheckOptions options) {
  options.files = expandRuleFiles(options.files);
  for (std::string& code : options.findings.allowed) {
    if (const auto* known = dsl::findCodeExplanation(code)) code = known->code;
  }
  RuleFindings all;
  for (const std::string& file : options.files) {
    RuleFindings one = findIn(file, options.findings);
    append(all.diagnostics, std::move(one.diagnostics));
    all.ruleCount += one.ruleCount;
    all.proven += one.proven;
    all.sampled += one.sampled;
  }
  tell(options, all);
  const bool hasFindings =
      dsl::hasErrors(all.diagnostics) || (options.strict && !all.diagnostics.empty());
  return hasFindings ? kUnusable : kComplete;
}

}  // namespace

Action declareCheck(CLI::App& command) {
  const auto options = std::make_shared<CheckOptions>();
  command.add_option("files", options->files, "rule files, folders of them, or - for stdin")
      ->required();
  command.add_option("--format", options->format, "pretty, json, sarif or gcc")
      ->check(CLI::IsMember({"pretty", "json", "sarif", "gcc"}));
  command.add_flag("--strict", options->strict, "warnings are findings, too: exit code 1");
  command.add_flag("--quick", options->findings.quick,
                   "only what the text tells; no proofs, no samples of matches");
  command.add_option("--samples", options->findings.samples, "matches tried for each rule")
      ->check(CLI::Range(1, 10'000'000));
  command.add_option("--allow", options->findings.allowed, "codes that are not told")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--pictures", options->findings.pictures,
                     "a folder for pictures of what was found");
  command.add_flag("-q,--quiet", options->quiet, "findings only");
  return [options] { return check(*options); };
}

}  // namespace af2::cli
