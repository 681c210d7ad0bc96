// Builds programs.
#include <cmath>
#include <limits>

#include "dsl/program/program.h"
#include "dsl/program/steps.h"

namespace af2::dsl {

Node ProgramBuilder::constant(double value) {
  Step step;
  step.op = Op::Constant;
  step.constant = value == 0 ? 0 : value;  // -0 and 0 share one step
  if (std::isnan(value)) step.constant = kNoValue;
  return insert(step);
}

Node ProgramBuilder::coordinate(int vertex, char axis) {
  Step step;
  step.op = axis == 'x' ? Op::CoordinateX : Op::CoordinateY;
  step.index = vertex;
  return insert(step);
}

Node ProgramBuilder::make(Op op, std::initializer_list<Node> arguments, int number) {
  return make(op, std::span<const Node>(arguments.begin(), arguments.size()), number);
}

Node ProgramBuilder::make(Op op, std::span<const Node> arguments, int number) {
  Step step;
  step.op = op;
  step.index = number;
  bool isConstant = isArithmetic(op);
  std::vector<double> values;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    step.arguments[i] = arguments[i];
    const auto value = constantValue(arguments[i]);
    isConstant = isConstant && value;
    values.push_back(value.value_or(kNoValue));
  }
  if (!isConstant) return insert(step);
  Step folded = step;
  for (std::size_t i = 0; i < arguments.size(); ++i) folded.arguments[i] = static_cast<Node>(i);
  return constant(evaluateStep(folded, values));
}

int ProgramBuilder::addShape(std::shared_ptr<const ShapeProgram> shape) {
  shapes_.push_back(std::move(shape));
  return static_cast<int>(shapes_.size()) - 1;
}

int ProgramBuilder::addFunction(std::shared_ptr<const UserFunction> function) {
  for (std::size_t i = 0; i < functions_.size(); ++i)
    if (functions_[i] == function) return static_cast<int>(i);
  functions_.push_back(std::move(function));
  return static_cast<int>(functions_.size()) - 1;
}

std::optional<double> ProgramBuilder::constantValue(Node node) const {
  const Step& step = steps_[index(node)];
  if (step.op != Op::Constant) return std::nullopt;
  return step.constant;
}

bool ProgramBuilder::dependsOnMatch(Node node) const { return dependsOnMatch_[index(node)]; }

Node ProgramBuilder::insert(const Step& step) {
  if (step.op == Op::Constant && std::isnan(step.constant)) {
    // NaN is not equal to itself, so a lookup would not find it.
    steps_.push_back(step);
    affine_.emplace_back();
    dependsOnMatch_.push_back(false);
    return static_cast<Node>(steps_.size()) - 1;
  }
  const auto [found, isNew] = known_.emplace(step.key(), static_cast<Node>(steps_.size()));
  if (!isNew) return found->second;
  const Needs needs = operationOf(step.op).needs;
  bool depends = needs != Needs::Nothing && needs != Needs::Level;
  for (Node argument : step.arguments)
    if (argument >= 0) depends = depends || dependsOnMatch(argument);
  affine_.push_back(affineOf(step));
  steps_.push_back(step);
  dependsOnMatch_.push_back(depends);
  return found->second;
}

namespace {

/// p + q. A tiny remainder of a cancellation is a rounding error and counts as zero.
double sum(double p, double q) {
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  const double result = p + q;
  return std::abs(result) <= kRounding * (std::abs(p) + std::abs(q)) ? 0 : result;
}

AffineForm combine(const AffineForm& a, double s, const AffineForm& b, double t) {
  AffineForm result;
  result.constant = sum(s * a.constant, t * b.constant);
  for (const auto& [coordinate, c] : a.coefficients) result.coefficients[coordinate] = s * c;
  for (const auto& [coordinate, c] : b.coefficients) {
    double& coefficient = result.coefficients[coordinate];
    coefficient = sum(coefficient, t * c);
  }
  for (auto entry = result.coefficients.begin(); entry != result.coefficients.end();)
    entry = entry->second == 0 ? result.coefficients.erase(entry) : entry + 1;
  return result;
}

}  // namespace

std::optional<AffineForm> ProgramBuilder::affineOf(const Step& s) const {
  const auto form = [&](std::size_t i) -> const std::optional<AffineForm>& {
    return affine_[index(s.arguments[i])];
  };
  const auto number = [&](std::size_t i) { return constantValue(s.arguments[i]); };
  switch (s.op) {
    case Op::Constant:
      return AffineForm{s.constant, {}};
    case Op::CoordinateX:
      return AffineForm{0, {{2 * s.index, 1.0}}};
    case Op::CoordinateY:
      return AffineForm{0, {{2 * s.index + 1, 1.0}}};
    case Op::Add:
    case Op::Subtract:
      if (!form(0) || !form(1)) return std::nullopt;
      return combine(*form(0), 1, *form(1), s.op == Op::Add ? 1 : -1);
    case Op::Negate:
      return form(0) ? std::optional(combine(*form(0), -1, {}, 0)) : std::nullopt;
    case Op::Multiply:
      if (number(0) && form(1)) return combine(*form(1), *number(0), {}, 0);
      if (number(1) && form(0)) return combine(*form(0), *number(1), {}, 0);
      return std::nullopt;
    case Op::Divide:
      if (!number(1) || !form(0) || *number(1) == 0) return std::nullopt;
      {
        AffineForm result = *form(0);
        result.constant /= *number(1);
        for (auto& [coordinate, c] : result.coefficients) c /= *number(1);
        return result;
      }
    default:
      return std::nullopt;
  }
}

Program ProgramBuilder::program(std::span<const Node> results) const {
  std::vector<bool> needed(steps_.size());
  for (Node node : results) needed[index(node)] = true;
  for (std::size_t i = steps_.size(); i-- > 0;)
    if (needed[i])
      for (Node argument : steps_[i].arguments)
        if (argument >= 0) needed[index(argument)] = true;
  Program result;
  std::vector<Node> place(steps_.size(), -1);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (!needed[i]) continue;
    place[i] = static_cast<Node>(result.steps_.size());
    Step step = steps_[i];
    for (Node& argument : step.arguments)
      if (argument >= 0) argument = place[index(argument)];
    result.steps_.push_back(step);
  }
  for (Node node : results) result.results_.push_back(place[index(node)]);
  result.shapes_ = shapes_;
  result.functions_ = functions_;
  return result;
}

}  // namespace af2::dsl
