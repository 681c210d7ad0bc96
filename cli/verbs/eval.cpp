// af2 eval
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/program/exit_code.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/match_arguments.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rule_files.h"
#include "dsl/run/evaluate.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

struct EvalOptions {
  std::string file, rule, format = "pretty";
  int level = 1;
  std::vector<std::string> match, points, segments, environment, plugins;
};

dsl::EvalRequest requestOf(const EvalOptions& options) {
  dsl::EvalRequest request;
  request.rule = options.rule;
  request.level = options.level;
  request.match = parseMatch("--match", options.match);
  request.environment = parseValues("--env", options.environment);
  for (const std::string& p : options.points) request.points.push_back(parsePoint("--point", p));
  for (const std::string& s : options.segments) {
    request.segments.push_back(parseSegment("--segment", s));
  }
  return request;
}

int evaluate(const EvalOptions& options) {
  const dsl::EvalRequest request = requestOf(options);
  const dsl::LoadedRules loaded = loadSoundRuleFile(options.file, {options.plugins});
  try {
    const dsl::EvalResult result = dsl::evaluateRule(*loaded.rules, request);
    fmt::print("{}", options.format == "json" ? dsl::toJson(result) : dsl::toText(result));
    return kComplete;
  } catch (const InputError& error) {
    throw UsageError(error.what());  // from here on only the command line can be wrong
  }
}

}  // namespace

Action declareEval(CLI::App& command) {
  const auto options = std::make_shared<EvalOptions>();
  command.add_option("FILE", options->file, "rule file, or - for stdin")->type_name("")->required();
  command.add_option("--rule", options->rule, "title of the rule")->type_name("TITLE")->required();
  command.add_option("--level,--class", options->level, "quality level, default 1")->type_name("N");
  const auto repeated = [&](const char* name, std::vector<std::string>& values, const char* form,
                            const char* help) {
    command.add_option(name, values, help)->type_name(form)->allow_extra_args(false);
  };
  repeated("--match", options->match, "VERTEX=X,Y",
           "position of a vertex, such as c=1.5,0.9; others are at their reference positions. "
           "Coordinates: a at (0, 0), b on the x axis; the unit is the wanted edge length");
  repeated("--point", options->points, "X,Y", "a point to test: is it in the free zone?");
  repeated("--segment", options->segments, "X,Y,X,Y",
           "an edge to test: does it meet the interior of the free zone?");
  repeated(
      "--env", options->environment, "NAME=NUMBER",
      "a fact about the surroundings: h=0.8, loop_size=7, turn(c)=120 (degrees), layer(c)=2, ...");
  command.add_option("--format", options->format, "pretty or json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"pretty", "json"}).description(""));
  addPluginOption(command, options->plugins);
  return [options] { return evaluate(*options); };
}

}  // namespace af2::cli
