// Compiles the order in which a rule set processes the edges of the front.
#include "dsl/compile/rule_set_compiler.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "dsl/program/compiled_forms.h"
#include "engine/front/row_order.h"

namespace af2::dsl {
namespace {

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

}  // namespace af2::dsl
