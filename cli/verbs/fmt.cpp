// af2 fmt
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/program/colour.h"
#include "cli/program/exit_code.h"
#include "cli/program/line_difference.h"
#include "cli/program/text_files.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/rule_files.h"
#include "dsl/format/printer.h"

namespace af2::cli {
namespace {

struct FmtOptions {
  std::vector<std::string> files;
  bool write = false, check = false;
};

/// Returns whether there are findings: an error or, with --check, a difference.
bool formatOne(const FmtOptions& options, const std::string& name) {
  const RuleText input = readRuleText(name);
  const dsl::Formatted formatted = dsl::format(input.name, input.text);
  fmt::print(stderr, "{}", dsl::toPretty(formatted.diagnostics, colourOf(stderr)));
  if (dsl::hasErrors(formatted.diagnostics)) return true;
  const bool differs = formatted.text != input.text;
  if (options.check) {
    if (differs) fmt::print("{}", lineDifference(input.name, input.text, formatted.text));
    return differs;
  }
  if (!options.write) fmt::print("{}", formatted.text);
  if (options.write && differs) {
    writeText(input.name, formatted.text);
    fmt::print("formatted {}\n", input.name);
  }
  return false;
}

int format(const FmtOptions& options) {
  bool hasFindings = false;
  for (const std::string& file : expandRuleFiles(options.files)) {
    if (options.write && file == "-") throw UsageError("--write cannot change standard input");
    hasFindings = formatOne(options, file) || hasFindings;
  }
  return hasFindings ? kUnusable : kComplete;
}

}  // namespace

Action declareFmt(CLI::App& command) {
  const auto options = std::make_shared<FmtOptions>();
  command
      .add_option("FILES", options->files, "rule files, folders with rule files, or - for stdin")
      ->type_name("")
      ->required();
  auto* write = command.add_flag("-w,--write", options->write, "write the result to the files");
  command
      .add_flag("--check", options->check,
                "print what would change, and exit with code 1 if anything would")
      ->excludes(write);
  return [options] { return format(*options); };
}

}  // namespace af2::cli
