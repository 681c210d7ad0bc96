// af2 compare
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/compare/comparison_text.h"
#include "cli/compare/fail_condition.h"
#include "cli/program/exit_code.h"
#include "cli/program/interrupt.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rule_loading.h"
#include "cli/rules/rules_location.h"
#include "engine/base/error.h"
#include "geometry/base/file_extension.h"
#include "geometry/io/output_file.h"

namespace af2::cli {
namespace {

struct CompareOptions {
  std::string first, second, suite, output, elements = "any", format = "pretty";
  std::vector<std::string> conditions, plugins;
  bool isLong = false, isTimed = false, isUnchecked = false, strictRules = false;
};

std::string namesOfMeasures() {
  std::string list;
  for (const ComparedMeasure& measure : comparedMeasures())
    list += fmt::format("\n  {:<20}{}", measure.name, measure.meaning);
  return list;
}

void checkOutput(const std::string& output) {
  if (output.empty()) return;
  if (geometry::extensionOf(output) != ".html")
    throw UsageError("--output " + output + ": give a file that ends in .html");
  try {
    geometry::checkWritable(output);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

ComparedRules rulesOf(const std::string& name, const CompareOptions& options) {
  const RuleLoading loading{options.format == "json", options.isUnchecked, options.plugins};
  return {name, loadRuleSet(findRuleFile(name), loading).rules};
}

void print(const ComparisonReport& report, const std::string& format) {
  if (format == "json") {
    using Json = nlohmann::ordered_json;
    fmt::print("{}\n", comparisonJson(report).dump(2, ' ', false, Json::error_handler_t::replace));
    return;
  }
  fmt::print("{}\n{}", comparisonText(report), failedModelsText(report));
  for (const std::string& note : report.notes) fmt::print("note: {}\n", note);
}

int compareSets(const CompareOptions& options) {
  std::vector<FailCondition> conditions;
  for (const std::string& text : options.conditions) {
    conditions.push_back(parseFailCondition(text));
    if (conditions.back().measure == "time" && !options.isTimed)
      throw UsageError(fmt::format("--fail-if \"{}\" needs --time", text));
  }
  if (options.isLong && !options.suite.empty())
    throw UsageError("--long is for the built-in suite, and --suite names another one");
  checkOutput(options.output);
  Interrupt interrupt;
  const std::array sets{rulesOf(options.first, options), rulesOf(options.second, options)};
  const bool onlyQuads = options.elements == "quad";
  for (const ComparedRules& set : sets)
    if (onlyQuads && !set.rules->makesQuads())
      throw UsageError(
          fmt::format("--elements quad: the rules '{}' make no quadrilaterals", set.name));
  const Suite suite = options.suite.empty() ? builtInSuite(options.isLong) : suiteIn(options.suite);
  ComparisonReport report{options.first, options.second, {}, {}, suite.notes};
  report.result = runSuite(suite, sets,
                           {options.isTimed, options.strictRules, onlyQuads,
                            !options.output.empty(), interrupt.token()});
  if (interrupt.requested()) {
    std::fputs("af2: stopped before all models were meshed\n", stderr);
    return kCancelled;
  }
  report.rows = compare(report.result, options.isTimed);
  if (!options.output.empty()) writeComparisonPage(report, options.output);
  print(report, options.format);
  bool hasFailed = false;
  for (const FailCondition& condition : conditions)
    if (const auto failure = failureOf(condition, report.rows)) {
      std::fputs(("af2: " + *failure + "\n").c_str(), stderr);
      hasFailed = true;
    }
  return hasFailed ? kUnusable : kComplete;
}

}  // namespace

Action declareCompare(CLI::App& command) {
  const auto options = std::make_shared<CompareOptions>();
  command.add_option("A", options->first, "the rule set to compare with")
      ->type_name("")
      ->required();
  command.add_option("B", options->second, "the rule set in question")->type_name("")->required();
  command
      .add_option("--suite", options->suite,
                  "a folder of models, with their sizes in suite.json; default: a built-in suite")
      ->type_name("DIR");
  command.add_flag("--long", options->isLong,
                   "more models of the built-in suite, and finer meshes");
  command
      .add_option("-o,--output", options->output,
                  "a page with the table, and the meshes of planar domains side by side (.html)")
      ->type_name("FILE");
  command
      .add_option("--fail-if", options->conditions,
                  "exit code 1 if this holds: worse, \"MEASURE worse\", \"MEASURE < NUMBER\" or "
                  "\"MEASURE > NUMBER\", e.g. \"sj_min < -0.02\"; may be repeated")
      ->type_name("CONDITION")
      ->take_all()
      ->expected(1);
  command.add_flag("--time", options->isTimed,
                   "also compare times; all runs on one thread, one after the other");
  command.add_flag("--strict-rules", options->strictRules,
                   "only rules make elements: faces fail where a front gets stuck");
  command
      .add_option("--elements", options->elements,
                  "any, or quad: finished meshes of quadrilaterals only, on even boundaries")
      ->type_name("KIND")
      ->check(CLI::IsMember({"any", "quad"}).description(""));
  command.add_flag("--unchecked", options->isUnchecked,
                   "use the rules even if the checks find errors that a rule file may allow");
  command.add_option("--format", options->format, "pretty or json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"pretty", "json"}).description(""));
  addPluginOption(command, options->plugins);
  command.footer("Measures, for --fail-if; raw.MEASURE means meshes without optimization:" +
                 namesOfMeasures());
  return [options] { return compareSets(*options); };
}

}  // namespace af2::cli
