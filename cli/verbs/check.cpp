// af2 check
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/program/colour.h"
#include "cli/program/exit_code.h"
#include "cli/program/line_difference.h"
#include "cli/program/text_files.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rule_files.h"
#include "cli/rules/rule_findings.h"
#include "dsl/text/diagnostic_codes.h"
#include "engine/base/stopwatch.h"

namespace af2::cli {
namespace {

using dsl::Diagnostic;

struct CheckOptions {
  std::vector<std::string> files;
  std::string format = "pretty";
  std::vector<std::string> allowed;  ///< ids of codes
  FindingOptions findings;
  bool strict = false, quiet = false;
  bool fix = false, diff = false;
};

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// " (G2, Z1 proven on the first 20 levels of 11 rules, sampled for 3)"
std::string proofText(const RuleFindings& all) {
  if (all.proven + all.sampled + all.refuted == 0) return {};
  std::string text = fmt::format(" (G2, Z1 proven on the first {} levels of {}",
                                 dsl::kLevelsLookedAt, counted(all.proven, "rule"));
  if (all.sampled > 0) text += fmt::format(", sampled for {}", all.sampled);
  if (all.refuted > 0) text += fmt::format(", false for {}", all.refuted);
  return text + ")";
}

std::size_t countOf(const std::vector<Diagnostic>& diagnostics, dsl::Severity severity) {
  return static_cast<std::size_t>(std::ranges::count(diagnostics, severity, &Diagnostic::severity));
}

std::string summaryOf(const CheckOptions& options, const RuleFindings& all, double seconds) {
  std::string files;
  if (options.files.size() > 1) files = counted(options.files.size(), "file") + ", ";
  return fmt::format("{}{}, {}, {} in {:.1f} s{}\n", files, counted(all.ruleCount, "rule"),
                     counted(countOf(all.diagnostics, dsl::Severity::Error), "error"),
                     counted(countOf(all.diagnostics, dsl::Severity::Warning), "warning"), seconds,
                     proofText(all));
}

void report(const CheckOptions& options, const RuleFindings& all, double seconds) {
  if (options.format == "json") return fmt::print("{}", dsl::toJson(all.diagnostics));
  if (options.format == "sarif") return fmt::print("{}", dsl::toSarif(all.diagnostics));
  if (options.format == "gcc") return fmt::print("{}", dsl::toGcc(all.diagnostics));
  fmt::print("{}", dsl::toPretty(all.diagnostics, colourOf(stdout)));
  if (!options.quiet) fmt::print("{}", summaryOf(options, all, seconds));
}

/// Corrects the files and prints the changes.
void fixFiles(const CheckOptions& options) {
  for (const std::string& file : options.files) {
    if (file == "-") throw UsageError("--fix and --diff need a file, not standard input");
    const RuleText input = readRuleText(file);
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) continue;  // a rule file that comes with AF2
    const dsl::FixedText fixed =
        fixRuleText(input, {options.findings.plugins, dsl::Externs::Declared});
    if (fixed.text == input.text) continue;
    fmt::print(stderr, "{}", lineDifference(input.name, input.text, fixed.text));
    if (!options.diff) writeText(input.name, fixed.text);
    for (const std::string& what : fixed.done)
      fmt::print(stderr, "{}: {}{}\n", input.name, what, options.diff ? " (not written)" : "");
  }
}

/// Appends new diagnostics only: a file that several others import is reported once.
void append(std::vector<Diagnostic>& all, std::vector<Diagnostic> more) {
  const std::size_t known = all.size();
  for (Diagnostic& diagnostic : more) {
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(known);
    if (std::find(all.begin(), end, diagnostic) == end) all.push_back(std::move(diagnostic));
  }
}

int check(CheckOptions options) {
  options.files = expandRuleFiles(options.files);
  for (const std::string& id : options.allowed) {
    const auto code = dsl::findCode(id);
    if (!code)
      throw UsageError(fmt::format(
          "--allow '{}': there is no such code; `af2 explain-code` lists all codes", id));
    options.findings.allowed.push_back(*code);
  }
  if (options.fix || options.diff) fixFiles(options);
  const Stopwatch watch;
  RuleFindings all;
  for (const std::string& file : options.files) {
    RuleFindings one = findIn(file, options.findings);
    append(all.diagnostics, std::move(one.diagnostics));
    all.ruleCount += one.ruleCount;
    all.proven += one.proven;
    all.sampled += one.sampled;
    all.refuted += one.refuted;
  }
  report(options, all, watch.seconds());
  const bool hasFindings =
      dsl::hasErrors(all.diagnostics) || (options.strict && !all.diagnostics.empty());
  return hasFindings ? kUnusable : kComplete;
}

}  // namespace

Action declareCheck(CLI::App& command) {
  const auto options = std::make_shared<CheckOptions>();
  command
      .add_option("FILES", options->files, "rule files, folders with rule files, or - for stdin")
      ->type_name("")
      ->required();
  command.add_option("--format", options->format, "pretty, json, sarif or gcc")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"pretty", "json", "sarif", "gcc"}).description(""));
  command.add_flag("--strict", options->strict, "exit with code 1 for warnings, too");
  command.add_flag("--quick", options->findings.quick,
                   "check only the text of the rules: no proofs, no sampled matches");
  command.add_flag("--prove", options->findings.prove,
                   "spend more time on proofs: several seconds for each difficult rule");
  command.add_flag("--fix", options->fix,
                   "first correct errors that have one obvious correction; prints the changes");
  command.add_flag("--diff", options->diff,
                   "print the changes that --fix would make, without writing the files");
  command
      .add_option("--samples", options->findings.samples, "number of matches tried for each rule")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000'000).description(""));
  command.add_option("--allow", options->allowed, "codes of diagnostics that are not reported")
      ->type_name("CODES")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--pictures", options->findings.pictures, "folder for pictures of the findings")
      ->type_name("DIR");
  addPluginOption(command, options->findings.plugins);
  command.add_flag("-q,--quiet", options->quiet, "print only the findings");
  return [options] { return check(*options); };
}

}  // namespace af2::cli
