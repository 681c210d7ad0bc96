#include "cli/rules/program_text.h"

#include <fmt/core.h>

#include "dsl/program/compiled_forms.h"

namespace af2::cli {
namespace {

using dsl::Op;
using dsl::Step;

std::string vertexText(int index, const VertexNames& names) {
  const auto i = static_cast<std::size_t>(index);
  return i < names.size() ? names[i] : fmt::format("corner {}", index + 1);
}

std::string stepText(const Step& step, const VertexNames& names) {
  const dsl::Operation& operation = dsl::operationOf(step.op);
  std::string text(operation.text);
  if (step.op == Op::Constant) return text + " " + numberText(step.constant);
  if (operation.index == dsl::IndexOf::Vertex) {
    return text + " " + vertexText(step.index, names);
  }
  if (operation.index == dsl::IndexOf::Other) text += fmt::format(" {}", step.index);
  for (const dsl::Node argument : step.arguments) {
    if (argument >= 0) text += fmt::format(" %{}", argument);
  }
  return text;
}

/// " + 0.5 b.x"; without leading blanks at the start of a sum.
void appendTerm(std::string& sum, double coefficient, const std::string& coordinate) {
  if (coefficient == 0) return;
  const bool isNegative = coefficient < 0;
  const double size = isNegative ? -coefficient : coefficient;
  sum += sum.empty() ? (isNegative ? "-" : "") : (isNegative ? " - " : " + ");
  if (size != 1 || coordinate.empty()) sum += numberText(size) + (coordinate.empty() ? "" : " ");
  sum += coordinate;
}

std::string affineText(const AffinePointTransform& transform, const VertexNames& names) {
  std::string x, y;
  appendTerm(x, transform.constant().x, "");
  appendTerm(y, transform.constant().y, "");
  for (const AffinePointTransform::Term& term : transform.terms()) {
    const std::string vertex = vertexText(term.vertex, names);
    appendTerm(x, term.xx, vertex + ".x");
    appendTerm(x, term.xy, vertex + ".y");
    appendTerm(y, term.yx, vertex + ".x");
    appendTerm(y, term.yy, vertex + ".y");
  }
  return fmt::format("x = {}, y = {}\n", x.empty() ? "0" : x, y.empty() ? "0" : y);
}

}  // namespace

std::string numberText(double number) { return fmt::format("{}", number); }

std::string programText(const dsl::Program& program, const VertexNames& names, int indent) {
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  std::string text = fmt::format("program of {} steps\n", program.stepCount());
  for (std::size_t i = 0; i < program.stepCount(); ++i) {
    text += fmt::format("{}%{} = {}\n", margin, i, stepText(program.steps()[i], names));
  }
  text += margin + "result";
  for (const dsl::Node node : program.results()) text += fmt::format(" %{}", node);
  return text + "\n";
}

std::string transformText(const AF2PointTransform& transform, const VertexNames& names,
                          int indent) {
  if (const auto* affine = dynamic_cast<const AffinePointTransform*>(&transform)) {
    return affineText(*affine, names);
  }
  if (const auto* general = dynamic_cast<const dsl::ExpressionTransform*>(&transform)) {
    return programText(general->program(), names, indent);
  }
  return "a custom transform\n";
}

std::string functionText(const AF2BindingFunction& function, const VertexNames& names, int indent) {
  if (const auto* general = dynamic_cast<const dsl::ExpressionFunction*>(&function)) {
    return programText(general->program(), names, indent);
  }
  return "a custom function\n";
}

}  // namespace af2::cli
