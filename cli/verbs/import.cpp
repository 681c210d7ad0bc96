// af2 import
#include <fmt/core.h>

#include <memory>

#include "cli/program/colour.h"
#include "cli/program/exit_code.h"
#include "cli/program/text_files.h"
#include "cli/program/verbs.h"
#include "cli/rules/rule_files.h"
#include "dsl/netgen/rls_import.h"

namespace af2::cli {
namespace {

struct ImportOptions {
  std::string input, output = "-", format = "pretty";
  bool quiet = false;
};

int importRules(const ImportOptions& options) {
  RuleText file = readRuleText(options.input);
  const dsl::ImportedRules rules = dsl::importRls(std::move(file.name), std::move(file.text));
  const bool failed = dsl::hasErrors(rules.diagnostics);
  if (!options.quiet || failed) {
    fmt::print(stderr, "{}",
               options.format == "json" ? dsl::toJson(rules.diagnostics)
                                        : dsl::toPretty(rules.diagnostics, colourOf(stderr)));
  }
  if (failed) return kUnusable;
  writeText(options.output, rules.text);
  return kComplete;
}

}  // namespace

Action declareImport(CLI::App& command) {
  const auto options = std::make_shared<ImportOptions>();
  command.add_option("FILE", options->input, "rule file of Netgen (.rls), or - for stdin")
      ->type_name("")
      ->required();
  command.add_option("-o,--output", options->output, "the .af2 file to write; - for stdout")
      ->type_name("FILE")
      ->capture_default_str();
  command.add_option("--format", options->format, "format of the diagnostics: pretty or json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"pretty", "json"}).description(""))
      ->capture_default_str();
  command.add_flag("-q,--quiet", options->quiet, "print only errors");
  return [options] { return importRules(*options); };
}

}  // namespace af2::cli
