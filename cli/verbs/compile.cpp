// af2 compile
#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "cli/program/exit_code.h"
#include "cli/program/verbs.h"
#include "cli/rules/match_arguments.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rule_dump.h"
#include "cli/rules/rule_files.h"

namespace af2::cli {
namespace {

struct CompileOptions {
  std::string file, rule;
  std::vector<std::string> plugins;
  bool dump = false;
};

/// Whether the engine can use its fast forms: affine points and a convex zone.
bool isAffine(const AF2Rule& rule) {
  const auto isAffineTransform = [](const std::shared_ptr<const AF2PointTransform>& transform) {
    return !transform || dynamic_cast<const AffinePointTransform*>(transform.get());
  };
  const auto* zone = dynamic_cast<const ConvexPolygonZoneDef*>(rule.definition().zone.get());
  return zone && std::ranges::all_of(rule.definition().newVertices, isAffineTransform) &&
         std::ranges::all_of(zone->corners(), [&](const ConvexPolygonZoneDef::Corner& corner) {
           return isAffineTransform(corner.preferred) && isAffineTransform(corner.limiting);
         });
}

int compile(const CompileOptions& options) {
  const dsl::LoadedRules loaded =
      loadSoundRuleFile(options.file, {options.plugins, dsl::Externs::Declared});
  const RuleSet& rules = *loaded.rules;
  if (!options.rule.empty()) findRule(rules, options.rule);
  if (options.dump) {
    fmt::print("{}", dumpText(rules, options.rule));
    return kComplete;
  }
  fmt::print("rule set \"{}\": {} rules, {} of them affine with a convex zone\n", rules.name(),
             rules.rules().size(), std::ranges::count_if(rules.rules(), isAffine));
  return kComplete;
}

}  // namespace

Action declareCompile(CLI::App& command) {
  const auto options = std::make_shared<CompileOptions>();
  command.add_option("FILE", options->file, "rule file, or - for stdin")->type_name("")->required();
  command.add_flag("--dump", options->dump, "print the compiled rules");
  command.add_option("--rule", options->rule, "with --dump: only the rule with this title")
      ->type_name("TITLE");
  addPluginOption(command, options->plugins);
  return [options] { return compile(*options); };
}

}  // namespace af2::cli
