// Compiles the settings of rule sets whose elements stand in rows: parity, counts, columns, and
// what happens at the end of rows and of the front.
#include "dsl/compile/rule_set_compiler.h"

#include <array>
#include <cmath>

#include "engine/base/turn.h"

namespace af2::dsl {

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

}  // namespace af2::dsl
