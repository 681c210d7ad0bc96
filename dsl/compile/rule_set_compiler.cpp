#include "dsl/compile/rule_set_compiler.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "dsl/compile/allowed_codes.h"
#include "dsl/compile/ideal_score.h"
#include "dsl/program/compiled_forms.h"
#include "dsl/program/known_values.h"
#include "engine/base/elementary.h"
#include "engine/base/error.h"

namespace af2::dsl {
namespace {

constexpr int kMaxLevels = 1000;
constexpr int kDefaultLevels = 50;

/// Rounds to a number of significant digits, so that messages do not show rounding errors.
double roundedTo(double value, int digits) {
  if (value == 0) return 0;
  const double scale = af2::power(10, digits - 1 - std::floor(std::log10(std::abs(value))));
  return std::isfinite(scale) ? std::round(value * scale) / scale : value;
}

/// The word that a setting begins with.
std::string wordOf(const Setting& setting, const Module& home) {
  const std::string_view text = home.source.text().substr(setting.span.begin);
  const auto isLetter = [](char c) { return c >= 'a' && c <= 'z'; };
  return std::string(text.begin(), std::ranges::find_if_not(text, isLetter));
}

}  // namespace

RuleSetCompiler::RuleSetCompiler(CompileContext& context, const Module& main,
                                 std::vector<PlacedRuleSet> blocks)
    : context_(context),
      main_(main),
      blocks_(std::move(blocks)),
      settings_(std::variant_size_v<SettingContent>) {
  for (const PlacedRuleSet& placed : blocks_) collect(placed);
  readClasses();
  readFade();
  readKinds();
  readParity();
  readCounts();
}

/// `front by` and `front rows` exclude each other.
std::size_t RuleSetCompiler::slotOf(const SettingContent& content) {
  const SettingContent rows = RowsSetting{}, order = OrderSetting{};
  return content.index() == rows.index() ? order.index() : content.index();
}

void RuleSetCompiler::collect(const PlacedRuleSet& placed) {
  std::vector<const Setting*> seen(settings_.size());
  for (const Setting& setting : placed.block->settings) {
    match(
        setting.content, [&](const MetaClause& meta) { readAllowed(meta, *placed.home); },
        // These settings are looked up where they are needed.
        [](const AnyOf<std::monostate, ElementsSetting, MatchSetting, FadeSetting, ScoreSetting,
                       AcceptSetting, ClearSetting, OrderSetting, RowsSetting, RowEndSetting,
                       EndSetting, ClassesSetting, ScaleSetting, ParitySetting, CountsSetting,
                       ColumnsSetting, FinishSetting> auto&) {});
    const std::size_t slot = slotOf(setting.content);
    if (slot == 0) continue;
    if (seen[slot])
      context_.tell(*placed.home, Code::DuplicateName, setting.span,
                    "'" + wordOf(setting, *placed.home) + "' is given twice in this rule set",
                    "keep one of them");
    seen[slot] = &setting;
    settings_[slot] = {&setting, placed.home};
  }
}

void RuleSetCompiler::readClasses() {
  shared_.maxLevel = kDefaultLevels;
  const Module* home = nullptr;
  const auto* classes = find<ClassesSetting>(&home);
  if (!classes) return;
  ProgramBuilder builder;
  ExpressionCompiler compiler(context_, *home, ExpressionPlace::Constant, Algebra(builder, {}));
  const auto first = compiler.constantNumber(classes->first, "the first level");
  const auto last = compiler.constantNumber(classes->last, "the last level");
  if (!first || !last) return;
  if (*first != 1)
    context_.tell(*home, Code::NotConstant, classes->first.span, "the first quality level is 1",
                  "write 1.." + shownNumber(std::max(*first, *last)));
  else if (*last < 1 || *last > kMaxLevels || *last != std::floor(*last))
    context_.tell(
        *home, Code::NotConstant, classes->last.span,
        "the last quality level must be a whole number from 1 to " + std::to_string(kMaxLevels),
        "an edge that no rule takes at the last level is stuck");
  else
    shared_.maxLevel = static_cast<int>(*last);
}

std::vector<double> RuleSetCompiler::table(const Expr& expr, const Module& home, const char* what,
                                           double least) {
  ProgramBuilder builder;
  ExpressionCompiler compiler(context_, home, ExpressionPlace::Level, Algebra(builder, {}));
  const Value value = compiler.number(expr, what);
  std::vector<double> result(static_cast<std::size_t>(shared_.maxLevel), least);
  if (value.isAny()) return result;
  if (!context_.missing.empty()) return result;
  const ExpressionFunction function(builder.program(std::array<Node, 1>{value.number}));
  for (int level = 1; level <= shared_.maxLevel; ++level) {
    const auto at = function.evaluate({{}, level, nullptr});
    if (at && *at >= least && *at <= 1e6) {
      result[static_cast<std::size_t>(level - 1)] = *at;
      continue;
    }
    context_.tell(
        home, Code::NoValue, expr.span,
        std::string(what) +
            (at ? " is " + shownNumber(roundedTo(*at, 6)) : std::string(" has no value")) +
            " at level " + std::to_string(level),
        "it must lie between " + std::string(least == 0 ? "0" : "-1e6") +
            " and 1e6 at every level from 1 to " + std::to_string(shared_.maxLevel));
    break;
  }
  return result;
}

void RuleSetCompiler::readFade() {
  const Module* home = nullptr;
  if (const auto* fade = find<FadeSetting>(&home)) {
    shared_.fade = table(fade->value, *home, "the fade", -1e6);
    shared_.fadeExpression = &fade->value;
    shared_.fadeHome = home;
    return;
  }
  for (int level = 1; level <= shared_.maxLevel; ++level) shared_.fade.push_back(1.0 / level);
}

void RuleSetCompiler::readKinds() {
  const Module* home = nullptr;
  const auto* elements = find<ElementsSetting>(&home);
  if (!elements) return;
  for (const Name& kind : elements->kinds) {
    if (!kinds_.insert(kind.text).second)
      context_.tell(*home, Code::DuplicateName, kind.span, "'" + kind.text + "' is given twice",
                    "give it once");
  }
}

Finish RuleSetCompiler::finish() const {
  const auto* setting = find<FinishSetting>();
  if (!setting) return Finish::Shape;
  const auto word = std::ranges::find(kFinishes, setting->finish.text);
  AF2_CHECK(word != kFinishes.end(), "the grammar allows no other word");
  return static_cast<Finish>(word - kFinishes.begin());
}

void RuleSetCompiler::readAllowed(const MetaClause& meta, const Module& home) {
  ProgramBuilder builder;
  ExpressionCompiler(context_, home, ExpressionPlace::Constant, Algebra(builder, {}))
      .checkAllowed(meta);
  allowed_.merge(allowedBy(meta));
}

std::optional<Program> RuleSetCompiler::metricProgram(const Expr& expr, const Module& home,
                                                      int corners) {
  ProgramBuilder builder;
  ExpressionCompiler compiler(context_, home, ExpressionPlace::Metric,
                              Algebra(builder, {corners, false}));
  for (int i = 0; i < corners; ++i) {
    compiler.corners.push_back(compiler.algebra().vertex(i));
    compiler.corners.back().vertex = -1;
  }
  const Value value = compiler.number(expr, "a score");
  if (value.isAny()) return std::nullopt;
  if (!builder.dependsOnMatch(value.number))
    context_.tell(home, Code::IdleClause, expr.span, "every element has the same score",
                  "let it depend on the corners, as metrics do: shape_size(10), size_error");
  return builder.program(std::array<Node, 1>{value.number});
}

/// Whether there can be a value at every level. If not, reports the lowest level without a value.
bool RuleSetCompiler::hasValues(const Program& program, const Expr& expr, const Module& home,
                                const char* what) {
  if (!asksForLevel(program)) return true;
  for (int level = 1; level <= shared_.maxLevel; ++level) {
    if (!KnownResults(program, level)[0].isNone()) continue;
    context_.tell(home, Code::NoValue, expr.span,
                  std::string(what) + " has no value at level " + std::to_string(level),
                  "a division by zero, a root of a negative number or the like");
    return false;
  }
  return true;
}

void RuleSetCompiler::checkMetric(const Program& program, const Expr& expr, const Module& home,
                                  int corners) {
  if (!context_.missing.empty()) return;  // no element has a value
  if (!hasValues(program, expr, home, "the score")) return;
  const ExpressionFunction function(program);
  checkIdealScore(context_, expr, home, corners, shared_.maxLevel,
                  [&](const std::vector<Point2>& ideal, int level) {
                    return function.evaluate({ideal, level, nullptr});
                  });
}

std::shared_ptr<const AF2ElementMetric> RuleSetCompiler::metric(const std::set<int>& sizes) {
  constexpr double kDefaultWeight = 10;
  const Module* home = nullptr;
  const auto* score = find<ScoreSetting>(&home);
  if (!score) return std::make_shared<ShapeSizeMetric>(kDefaultWeight);
  const Expr& expr = score->metric;
  const bool isNameOrCall =
      (expr.kind == ExprKind::Name || expr.kind == ExprKind::Call) && expr.qualifier.empty();
  if (isNameOrCall && expr.parts.empty())
    if (const auto declared = home->functions.find(expr.name);
        declared != home->functions.end() && declared->second.external &&
        declared->second.external->isMissing && declared->second.external->metric) {
      context_.missing.push_back({expr.name, declared->second.home, declared->second.span});
      return declared->second.external->metric;
    }
  if (isNameOrCall && expr.parts.empty())
    if (const auto found = context_.registry.metrics().find(expr.name);
        found != context_.registry.metrics().end()) {
      for (const int corners : sizes)
        checkIdealScore(context_, expr, *home, corners, shared_.maxLevel,
                        [&](const std::vector<Point2>& ideal, int level) {
                          return found->second->badnessAt(ideal, level);
                        });
      return found->second;
    }
  std::optional<Program> triangle, quad;
  if (sizes.contains(3)) triangle = metricProgram(expr, *home, 3);
  if (sizes.contains(4)) quad = metricProgram(expr, *home, 4);
  if (sizes.empty()) metricProgram(expr, *home, 3);
  if (triangle) checkMetric(*triangle, expr, *home, 3);
  if (quad) checkMetric(*quad, expr, *home, 4);
  if (isNameOrCall && expr.name == "shape_size" && expr.parts.size() == 1) {
    ProgramBuilder builder;
    ExpressionCompiler compiler(context_, *home, ExpressionPlace::Metric, Algebra(builder, {}));
    const Value weight = compiler.number(expr.parts[0], "the weight");
    if (weight.isAny()) return std::make_shared<ShapeSizeMetric>(kDefaultWeight);
    if (const auto constant = builder.constantValue(weight.number))
      return std::make_shared<ShapeSizeMetric>(*constant);
  }
  return std::make_shared<ExpressionMetric>(std::move(triangle), std::move(quad));
}

std::shared_ptr<const AF2Acceptance> RuleSetCompiler::acceptance() {
  const Module* home = nullptr;
  const auto* accept = find<AcceptSetting>(&home);
  if (!accept) return nullptr;
  ProgramBuilder builder;
  ExpressionCompiler compiler(context_, *home, ExpressionPlace::Acceptance, Algebra(builder, {}));
  Node all = builder.constant(1);
  for (const Expr& condition : accept->conditions) {
    const Value value = compiler.truth(condition, "the argument of `accept`");
    if (value.isAny()) return nullptr;
    hasValues(builder.program(std::array<Node, 1>{value.number}), condition, *home,
              "the argument of `accept`");
    all = builder.make(Op::And, {all, value.number});
  }
  if (const auto constant = builder.constantValue(all); constant && *constant != 0) return nullptr;
  const Expr& expr = accept->conditions.front();
  const bool isBound = accept->conditions.size() == 1 && expr.kind == ExprKind::Binary &&
                       expr.name == "<" && expr.parts[0].kind == ExprKind::Name &&
                       expr.parts[0].name == "score";
  if (isBound) {
    const Value bound = compiler.evaluate(expr.parts[1]);
    const ExpressionFunction function(builder.program(std::array<Node, 1>{bound.number}));
    const auto steps = function.program().steps();
    const bool asksScore =
        std::any_of(steps.begin(), steps.end(), [](const Step& s) { return s.op == Op::Input; });
    if (!asksScore)
      return std::make_shared<ScoreBound>(table(expr.parts[1], *home, "the bound", -1e6));
  }
  return std::make_shared<ExpressionAcceptance>(builder.program(std::array<Node, 1>{all}));
}

std::optional<DiagnosticPlace> RuleSetCompiler::acceptancePlace() const {
  const Module* home = nullptr;
  const auto* accept = find<AcceptSetting>(&home);
  if (!accept) return std::nullopt;
  return placeOf(home->source,
                 cover(accept->conditions.front().span, accept->conditions.back().span));
}

RuleSetDefinition RuleSetCompiler::finish(const std::set<int>& sizes) {
  RuleSetDefinition definition;
  definition.name = blocks_.empty() ? main_.source.name() : blocks_.back().block->name.text;
  definition.maxLevel = shared_.maxLevel;
  const Module* home = nullptr;
  if (const auto* match = find<MatchSetting>(&home)) {
    definition.matchTolerance = table(match->value, *home, "the match tolerance", 0);
  } else {
    for (int level = 1; level <= shared_.maxLevel; ++level)
      definition.matchTolerance.push_back(0.5 + 0.3 * level);
  }
  if (const auto* clear = find<ClearSetting>(&home))
    definition.clearance = table(clear->value, *home, "the clearance", 0);
  definition.columns = columns();
  definition.rowRounds = rowRounds();
  definition.cleanDepth = cleanDepth();
  definition.metric = metric(sizes);
  if (const auto* score = find<ScoreSetting>()) {
    definition.scoreOf = score->fold.text == "sum"    ? ScoreOf::Sum
                         : score->fold.text == "mean" ? ScoreOf::Mean
                                                      : ScoreOf::Max;
  }
  definition.acceptance = acceptance();
  definition.order = order();
  if (const auto* scale = find<ScaleSetting>(&home)) {
    if (scale->unit.text == "base")
      definition.unit = ChartUnit::BaseLength;
    else if (scale->unit.text != "h")
      context_.tell(*home, Code::NotConstant, scale->unit.span,
                    "'" + scale->unit.text + "' is not a unit of length",
                    "write `scale h;` or `scale base;`");
  }
  definition.parity = parity_;
  definition.finish = finish();
  return definition;
}

}  // namespace af2::dsl
