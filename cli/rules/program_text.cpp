#include "cli/rules/program_text.h"

#include <fmt/core.h>

#include "dsl/program/compiled_forms.h"

namespace af2::cli {
namespace {

using dsl::Op;
using dsl::Step;

const char* wordFor(Op op) {
  switch (op) {
    case Op::Unknown:
      return "unknown";
    case Op::Constant:
      return "constant";
    case Op::CoordinateX:
      return "x of";
    case Op::CoordinateY:
      return "y of";
    case Op::Level:
      return "q";
    case Op::Input:
      return "input";
    case Op::Layer:
      return "layer of";
    case Op::OnBoundary:
      return "on_boundary of";
    case Op::Valence:
      return "valence of";
    case Op::Turn:
      return "turn of";
    case Op::LoopSize:
      return "loop_size";
    case Op::SizeAt:
      return "h at";
    case Op::FrontDistance:
      return "dist_front at";
    case Op::CurvatureAt:
      return "curvature at";
    case Op::Add:
      return "add";
    case Op::Subtract:
      return "subtract";
    case Op::Multiply:
      return "multiply";
    case Op::Divide:
      return "divide";
    case Op::Negate:
      return "negate";
    case Op::Power:
      return "power";
    case Op::SquareRoot:
      return "sqrt";
    case Op::Sine:
      return "sin";
    case Op::Cosine:
      return "cos";
    case Op::Tangent:
      return "tan";
    case Op::Atan2:
      return "atan2";
    case Op::Absolute:
      return "abs";
    case Op::Minimum:
      return "min";
    case Op::Maximum:
      return "max";
    case Op::Sweep:
      return "sweep";
    case Op::BisectX:
      return "bisector x";
    case Op::BisectY:
      return "bisector y";
    case Op::Less:
      return "less";
    case Op::LessEqual:
      return "less or equal";
    case Op::Equal:
      return "equal";
    case Op::And:
      return "and";
    case Op::Or:
      return "or";
    case Op::Not:
      return "not";
    case Op::Select:
      return "select";
    case Op::LeftTurn:
      return "turns left";
    case Op::NotRightTurn:
      return "does not turn right";
    case Op::Inside:
      return "inside shape";
    case Op::Call:
      return "call function";
  }
  return "unknown";
}

bool namesVertex(Op op) {
  return op == Op::CoordinateX || op == Op::CoordinateY || op == Op::Layer ||
         op == Op::OnBoundary || op == Op::Valence || op == Op::Turn;
}

std::string vertexText(int index, const VertexNames& names) {
  const auto i = static_cast<std::size_t>(index);
  return i < names.size() ? names[i] : fmt::format("corner {}", index + 1);
}

std::string stepText(const Step& step, const VertexNames& names) {
  std::string text = wordFor(step.op);
  if (step.op == Op::Constant) return text + " " + numberText(step.constant);
  if (namesVertex(step.op)) return text + " " + vertexText(step.index, names);
  if (step.op == Op::Inside || step.op == Op::Call || step.op == Op::Input) {
    text += fmt::format(" {}", step.index);
  }
  for (const dsl::Node argument : step.arguments) {
    if (argument >= 0) text += fmt::format(" %{}", argument);
  }
  return text;
}

/// " + 0.5 b.x", without the blanks at the start of a sum.
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
  return "a transform of one's own\n";
}

std::string functionText(const AF2BindingFunction& function, const VertexNames& names, int indent) {
  if (const auto* general = dynamic_cast<const dsl::ExpressionFunction*>(&function)) {
    return programText(general->program(), names, indent);
  }
  return "a function of one's own\n";
}

}  // namespace af2::cli
