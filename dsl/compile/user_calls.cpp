// Calls of functions and metrics that programs register.
#include <array>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dsl/compile/expressions.h"

namespace af2::dsl {

/// Without an implementation the call has no value, and what it is part of is not evaluated.
Value ExpressionCompiler::callExtern(const Expr& expr, const FunctionName& declared) {
  const ExternName& external = *declared.external;
  if (external.isMissing) context_.missing.push_back({expr.name, declared.home, declared.span});
  if (external.function) return callUserFunction(expr, external.function);
  if (external.shape) return callUserShape(expr, external.shape);
  return callUserMetric(expr, external.metric);
}

Value ExpressionCompiler::callUserMetric(const Expr& expr,
                                         const std::shared_ptr<const AF2ElementMetric>& metric) {
  std::vector<Value> values;
  for (const Expr& part : expr.parts) values.push_back(evaluate(part));
  const std::vector<Value>& measured = values.empty() ? corners : values;
  if (measured.size() < 3 || measured.size() > 4) {
    tell(Code::ArgumentCount, expr.span, "a registered metric takes three or four corners", "",
         expr.name + "(u, v, w, x)");
    return {};
  }
  auto wrapped = std::make_shared<UserFunction>();
  wrapped->name = expr.name;
  wrapped->value = [metric](std::span<const double> n) {
    std::array<Point2, 4> points{};
    for (std::size_t i = 0; i < n.size() / 2; ++i) points[i] = {n[2 * i], n[2 * i + 1]};
    return metric->badnessAt({points.data(), n.size() / 2}, static_cast<int>(n.back()));
  };
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (!values.empty() && !fits(measured[i], 'p', nullptr, expr.parts[i], expr.name)) return {};
    nodes.push_back(measured[i].at.x);
    nodes.push_back(measured[i].at.y);
  }
  nodes.push_back(hasLevel() ? builder().make(Op::Level, std::initializer_list<Node>{})
                             : builder().constant(1));
  const int index = builder().addFunction(std::move(wrapped));
  return algebra_.scalar(Type::Number, builder().make(Op::Call, nodes, index));
}

Value ExpressionCompiler::callUserFunction(const Expr& expr,
                                           const std::shared_ptr<const UserFunction>& function) {
  const std::string usage = expr.name + " with arguments of the kinds " + function->parameters;
  if (expr.parts.size() != function->parameters.size()) {
    tell(Code::ArgumentCount, expr.span,
         "'" + expr.name + "' is called with " + std::to_string(expr.parts.size()) +
             (expr.parts.size() == 1 ? " argument" : " arguments"),
         "", "it takes " + std::to_string(function->parameters.size()));
    return {};
  }
  std::vector<Node> nodes;
  bool isRight = true;
  for (std::size_t i = 0; i < expr.parts.size(); ++i) {
    const Value v = evaluate(expr.parts[i]);
    if (!fits(v, function->parameters[i], nullptr, expr.parts[i], usage)) {
      isRight = false;
    } else if (v.type == Type::Geometric) {
      nodes.push_back(v.at.x);
      nodes.push_back(v.at.y);
    } else {
      nodes.push_back(v.number);
    }
  }
  if (!isRight) return {};
  const Type type = function->result == 't'   ? Type::Truth
                    : function->result == 'a' ? Type::Angle
                                              : Type::Number;
  const int index = builder().addFunction(function);
  return algebra_.scalar(type, builder().make(Op::Call, nodes, index));
}

}  // namespace af2::dsl
