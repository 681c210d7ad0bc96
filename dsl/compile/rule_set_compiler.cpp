#include "dsl/compile/rule_set_compiler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dsl/compile/allowed_codes.h"
#include "dsl/compile/ideal_score.h"
#include "dsl/program/compiled_forms.h"
#include "dsl/program/known_values.h"
#include "engine/base/error.h"
#include "engine/base/turn.h"
#include "engine/front/row_order.h"

namespace af2::dsl {
namespace {

constexpr int kMaxLevels = 1000;
constexpr int kDefaultLevels = 50;

/// Rounds to a number of significant digits, so that messages do not show rounding errors.
double roundedTo(double value, int digits) {
  if (value == 0) return 0;
  const double scale = std::pow(10, digits - 1 - std::floor(std::log10(std::abs(value))));
  return std::isfinite(scale) ? std::round(value * scale) / scale : value;
}

/// The word that a setting begins with.
std::string wordOf(const Setting& setting, const Module& home) {
  const std::string_view text = home.source.text().substr(setting.span.begin);
  const auto isLetter = [](char c) { return c >= 'a' && c <= 'z'; };
  return std::string(text.begin(), std::ranges::find_if_not(text, isLetter));
}

/// `front by` and `front rows` exclude each other.
std::size_t slotOf(const SettingContent& content) {
  const SettingContent rows = RowsSetting{}, order = OrderSetting{};
  return content.index() == rows.index() ? order.index() : content.index();
}

/// level * [0] + layer(a) * [1] + layer(b) * [2] + [3]
using Linear = std::array<double, 4>;

std::optional<Linear> linearForm(const Program& program) {
  std::vector<std::optional<Linear>> forms;
  for (const Step& step : program.steps()) {
    const auto form = [&](std::size_t i) {
      return forms[static_cast<std::size_t>(step.arguments[i])];
    };
    const auto isConstant = [](const std::optional<Linear>& f) {
      return f && (*f)[0] == 0 && (*f)[1] == 0 && (*f)[2] == 0;
    };
    const auto scaled = [](Linear f, double s) {
      for (double& c : f) c *= s;
      return f;
    };
    std::optional<Linear> result;
    if (step.op == Op::Constant) result = Linear{0, 0, 0, step.constant};
    if (step.op == Op::Level) result = Linear{1, 0, 0, 0};
    if (step.op == Op::Layer) result = step.index == 0 ? Linear{0, 1, 0, 0} : Linear{0, 0, 1, 0};
    if (step.op == Op::Add && form(0) && form(1)) {
      result = *form(0);
      for (std::size_t i = 0; i < 4; ++i) (*result)[i] += (*form(1))[i];
    }
    if (step.op == Op::Multiply && isConstant(form(0)) && form(1))
      result = scaled(*form(1), (*form(0))[3]);
    else if (step.op == Op::Multiply && isConstant(form(1)) && form(0))
      result = scaled(*form(0), (*form(1))[3]);
    forms.push_back(result);
  }
  return forms[static_cast<std::size_t>(program.results()[0])];
}

std::shared_ptr<const AF2FrontOrder> layeredOrder(const Program& key) {
  const auto form = linearForm(key);
  if (!form) return nullptr;
  for (double c : *form)
    if (c < 0 || c > 1000 || c != std::floor(c)) return nullptr;
  return std::make_shared<LayeredFrontOrder>(
      static_cast<int>((*form)[0]), static_cast<int>((*form)[1]), static_cast<int>((*form)[2]));
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

template <class Content>
const Content* RuleSetCompiler::find(const Module** home) const {
  const SettingContent like = Content{};
  const Found& found = settings_[slotOf(like)];
  if (!found.setting) return nullptr;
  if (home) *home = found.home;
  return std::get_if<Content>(&found.setting->content);
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

void RuleSetCompiler::readParity() {
  const Module* home = nullptr;
  const auto* parity = find<ParitySetting>(&home);
  if (!parity) return;
  if (parity->parity.text == "even")
    parity_ = Parity::Even;
  else if (parity->parity.text != "any")
    context_.tell(*home, Code::NotConstant, parity->parity.span,
                  "'" + parity->parity.text + "' is not a parity",
                  "write `parity even;` or `parity any;`");
}

/// The angles of `counts`, increasing.
void RuleSetCompiler::readCounts() {
  const Module* home = nullptr;
  const auto* counts = find<CountsSetting>(&home);
  if (!counts) return;
  ProgramBuilder builder;
  ExpressionCompiler compiler(context_, *home, ExpressionPlace::Constant, Algebra(builder, {}));
  std::array<double, 3> bounds{};
  const Span all = cover(counts->bounds.front().span, counts->bounds.back().span);
  if (counts->bounds.size() != bounds.size())
    return context_.tell(
        *home, Code::ArgumentCount, all,
        "'counts' takes three angles, not " + std::to_string(counts->bounds.size()),
        "from these on a vertex wants 2, 3 and 4 elements: `counts 130deg, 235deg, "
        "315deg;`");
  double last = 0;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const Expr& expr = counts->bounds[i];
    const Value value = compiler.evaluate(expr);
    if (value.isAny()) return;
    const auto angle =
        value.type == Type::Angle ? builder.constantValue(value.number) : std::nullopt;
    if (!angle || *angle <= last || *angle >= kFullTurn)
      return context_.tell(*home, Code::NotConstant, expr.span,
                           "the angles of 'counts' increase between 0deg and 360deg",
                           "write for example `counts 130deg, 235deg, 315deg;`");
    last = *angle;
    bounds[i] = sweepOfAngle(*angle);
  }
  shared_.counts = bounds;
}

std::optional<ColumnLimits> RuleSetCompiler::columns() {
  const Module* home = nullptr;
  const auto* columns = find<ColumnsSetting>(&home);
  if (!columns) return std::nullopt;
  ProgramBuilder builder;
  ExpressionCompiler compiler(context_, *home, ExpressionPlace::Constant, Algebra(builder, {}));
  const auto low = compiler.constantNumber(columns->low, "the shortest edge");
  const auto high = compiler.constantNumber(columns->high, "the longest edge");
  const auto layer = compiler.constantNumber(columns->layer, "a layer");
  if (!low || !high || !layer) return std::nullopt;
  if (!shared_.counts)
    context_.tell(*home, Code::MissingCounts, cover(columns->low.span, columns->layer.span),
                  "'columns' changes the counts of vertices, and the rule set has none",
                  "add `counts 130deg, 235deg, 315deg;`");
  if (!(*low > 0 && *low < 1 && *high > 1 && *high <= 10))
    context_.tell(*home, Code::NotConstant, cover(columns->low.span, columns->high.span),
                  "columns begin above and end below the target size",
                  "write a number between 0 and 1 and one above 1, as in 0.7..1.4");
  if (!(*layer >= 0 && *layer <= 1e6 && *layer == std::floor(*layer)))
    context_.tell(*home, Code::NotConstant, columns->layer.span, "a layer is a whole number from 0",
                  "0 is the boundary; 3 keeps the rows at the boundary regular");
  return ColumnLimits{*low, *high, static_cast<int>(*layer)};
}

/// The lower end of the range if the value is not a whole number in it, which is told.
int RuleSetCompiler::wholeNumber(const Module& home, const Expr& value, const std::string& what,
                                 Range range, const std::string& usual) {
  ProgramBuilder builder;
  ExpressionCompiler compiler(context_, home, ExpressionPlace::Constant, Algebra(builder, {}));
  const auto number = compiler.constantNumber(value, what);
  if (!number) return range.first;
  if (*number >= range.first && *number <= range.last && *number == std::floor(*number))
    return static_cast<int>(*number);
  context_.tell(home, Code::NotConstant, value.span,
                what + " is a whole number from " + std::to_string(range.first) + " to " +
                    std::to_string(range.last),
                usual);
  return range.first;
}

int RuleSetCompiler::rowRounds() {
  const Module* home = nullptr;
  const auto* setting = find<RowEndSetting>(&home);
  if (!setting) return 0;
  return wholeNumber(*home, setting->rounds, "the number of rounds", {1, 100}, "3 is usual");
}

std::optional<int> RuleSetCompiler::cleanDepth() {
  const Module* home = nullptr;
  const auto* setting = find<EndSetting>(&home);
  if (!setting) return std::nullopt;
  return wholeNumber(*home, setting->depth, "the depth of the clean-up", {0, 3},
                     "2 is usual; 0 leaves it out");
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

std::shared_ptr<const AF2FrontOrder> RuleSetCompiler::rows(const RowsSetting& setting,
                                                           const Module& home) {
  RowStart start = RowStart::SmallestTurn;
  for (const MetaEntry& argument : setting.arguments) {
    const std::string& value = argument.value.text;
    if (argument.key.text != "start")
      context_.tell(home, Code::UnknownName, argument.key.span,
                    "'rows' has no argument '" + argument.key.text + "'",
                    "write rows(start: smallest_turn)");
    else if (std::ranges::find(kRowStarts, value) == kRowStarts.end())
      context_.tell(home, Code::UnknownName, argument.value.span,
                    "rows cannot start at '" + value + "'",
                    "rows start at smallest_turn or at oldest");
    else if (value == "oldest")
      start = RowStart::Oldest;
  }
  return std::make_shared<RowFrontOrder>(start);
}

std::shared_ptr<const AF2FrontOrder> RuleSetCompiler::order() {
  const Module* home = nullptr;
  if (const auto* setting = find<RowsSetting>(&home)) return rows(*setting, *home);
  const auto* setting = find<OrderSetting>(&home);
  const auto usual = std::make_shared<LayeredFrontOrder>(1, 1, 1);
  if (!setting) return usual;
  ProgramBuilder builder;
  ExpressionCompiler compiler(context_, *home, ExpressionPlace::FrontOrder,
                              Algebra(builder, {2, false, shared_.counts}));
  compiler.inChain = {true, true};
  for (int i = 0; i < 2; ++i) {
    Local end;
    end.value = compiler.algebra().vertex(i);
    compiler.locals[i == 0 ? "a" : "b"] = std::move(end);
  }
  std::vector<Program> keys;
  for (const Expr& expr : setting->keys) {
    const Value value = compiler.evaluate(expr);
    if (value.isAny()) return usual;
    if (value.type != Type::Number && value.type != Type::Angle) {
      compiler.tell(Code::WrongType, expr.span, "the front is ordered by numbers",
                    "this is " + describe(value));
      return usual;
    }
    keys.push_back(builder.program(std::array<Node, 1>{value.number}));
    hasValues(keys.back(), expr, *home, "this key");
  }
  if (keys.size() == 1)
    if (auto fast = layeredOrder(keys[0])) return fast;
  return std::make_shared<ExpressionFrontOrder>(std::move(keys));
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
