// af2 draw
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/program/exit_code.h"
#include "cli/program/number_lists.h"
#include "cli/program/text_files.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/match_arguments.h"
#include "cli/rules/picture_format.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rule_files.h"
#include "cli/rules/test_picture.h"
#include "dsl/picture/coverage_picture.h"
#include "dsl/picture/rule_picture.h"
#include "dsl/proof/coverage.h"

namespace af2::cli {
namespace {

struct DrawOptions {
  std::string file, rule, test, output, levels;
  std::vector<std::string> match, plugins;
  bool coverage = false, noNames = false, noTolerances = false;
  int size = 0;
};

dsl::PictureOptions pictureOptions(const DrawOptions& options, const RuleSet& rules, int usual) {
  dsl::PictureOptions picture;
  picture.width = picture.height = options.size > 0 ? options.size : usual;
  if (!options.levels.empty()) picture.levels = parseIds("--levels", options.levels);
  for (const int level : picture.levels)
    if (level > rules.maxLevel())
      throw UsageError(fmt::format("--levels {}: the levels are 1 to {}", level, rules.maxLevel()));
  picture.names = !options.noNames;
  picture.tolerances = !options.noTolerances;
  return picture;
}

dsl::PiecePictureOptions pieceOptions(const DrawOptions& options) {
  constexpr int kSmallest = 240;  // for the text
  if (options.size > 0 && options.size < kSmallest)
    throw UsageError(fmt::format("--size {}: a picture of a test needs at least {} pixels",
                                 options.size, kSmallest));
  dsl::PiecePictureOptions picture;
  if (options.size > 0) picture.width = picture.height = options.size;
  picture.names = !options.noNames;
  return picture;
}

std::string drawOne(const DrawOptions& options, const RuleSet& rules, dsl::PictureFormat format) {
  const AF2Rule& rule = findRule(rules, options.rule);
  const dsl::PictureOptions picture = pictureOptions(options, rules, 420);
  if (options.match.empty()) return dsl::drawRule(rules, rule, format, picture);
  dsl::DrawnMatch match;
  match.level = picture.levels.empty() ? rule.definition().firstLevel : picture.levels.front();
  match.vertices = matchedVertices(rule, parseMatch("--match", options.match), match.level);
  return dsl::drawMatch(rules, rule, match, format, picture);
}

int draw(DrawOptions options) {
  if (!options.match.empty() && options.rule.empty()) {
    throw UsageError("--match needs --rule: it places the vertices of one rule");
  }
  if (!options.test.empty() && !options.rule.empty()) {
    throw UsageError("--test and --rule draw different pictures; give one of them");
  }
  if (options.output.empty()) options.output = stemOf(options.file) + ".svg";
  const dsl::PictureFormat format =
      options.output == "-" ? dsl::PictureFormat::Svg : pictureFormatOf(options.output, "--output");
  // A zone without an implementation is left out of a picture of a rule; coverage and tests need
  // it.
  const bool mustEvaluate = options.coverage || !options.test.empty();
  const dsl::Externs externs = mustEvaluate ? dsl::Externs::Registered : dsl::Externs::Declared;
  const dsl::LoadedRules loaded = loadSoundRuleFile(options.file, {options.plugins, externs});
  const RuleSet& rules = *loaded.rules;
  std::string drawn = fmt::format("{} rules", rules.rules().size());
  std::string picture;
  if (options.coverage) {
    drawn = "coverage";
    picture = dsl::drawCoverage(dsl::measureCoverage(rules), rules.name(), format);
  } else if (!options.test.empty()) {
    drawn = fmt::format("test \"{}\"", options.test);
    picture = drawTest(loaded, options.test, format, pieceOptions(options));
  } else if (!options.rule.empty()) {
    drawn = fmt::format("rule \"{}\"", options.rule);
    picture = drawOne(options, rules, format);
  } else {
    picture = dsl::drawRuleSet(rules, format, pictureOptions(options, rules, 300));
  }
  writeText(options.output, picture);
  if (options.output != "-") fmt::print("drew {} -> {}\n", drawn, options.output);
  return kComplete;
}

}  // namespace

Action declareDraw(CLI::App& command) {
  const auto options = std::make_shared<DrawOptions>();
  command.add_option("FILE", options->file, "rule file, or - for stdin")->type_name("")->required();
  command.add_option("--rule", options->rule, "only the rule with this title")->type_name("TITLE");
  command
      .add_option("--test", options->test,
                  "the test with this title: its front, and what the rules did there")
      ->type_name("TITLE");
  command
      .add_option("-o,--output", options->output,
                  "output picture, .svg or .png; default: the name of the rule file with .svg; - "
                  "for stdout")
      ->type_name("FILE");
  command
      .add_option("--levels,--level,--class", options->levels,
                  "quality levels whose zones are shown, such as 1,5,20")
      ->type_name("LEVELS");
  command
      .add_option("--match", options->match, "with --rule: position of a vertex, such as c=0.6,0.9")
      ->type_name("VERTEX=X,Y")
      ->allow_extra_args(false);
  command
      .add_option("--size", options->size, "width and height of one rule, or of a test, in pixels")
      ->type_name("N")
      ->check(CLI::Range(50, 4000).description(""));
  command.add_flag("--no-names", options->noNames, "do not draw the names of vertices");
  command.add_flag("--no-tolerances", options->noTolerances, "do not draw the tolerance ellipses");
  command.add_flag("--coverage", options->coverage,
                   "draw which situations of the front the rules accept, and at which level");
  addPluginOption(command, options->plugins);
  return [options] { return draw(*options); };
}

}  // namespace af2::cli
