#include "dsl/program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dsl/registry.h"
#include "dsl/shape_program.h"
#include "dsl/steps.h"
#include "engine/error.h"
#include "engine/predicates.h"

namespace af2::dsl {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr double kTurn = 2 * std::numbers::pi;

double finite(double x) { return std::isfinite(x) ? x : kNoValue; }
double truth(bool b) { return b ? 1.0 : 0.0; }

/// Quarter turns come out exactly, so that rot(v, 90deg) keeps coordinates to the last bit.
std::optional<int> quarterTurns(double angle) {
  const double quarters = angle / (kTurn / 4);
  const double whole = std::round(quarters);
  // An angle without a value is near nothing.
  const bool isNear = std::abs(quarters - whole) <= 1e-14 * std::max(1.0, std::abs(whole));
  if (!isNear || std::abs(whole) > 1e6) return std::nullopt;
  return ((static_cast<int>(whole) % 4) + 4) % 4;
}

double sine(double angle) {
  constexpr std::array<double, 4> exact{0, 1, 0, -1};
  const auto quarters = quarterTurns(angle);
  return quarters ? exact[static_cast<std::size_t>(*quarters)] : std::sin(angle);
}

double cosine(double angle) {
  constexpr std::array<double, 4> exact{1, 0, -1, 0};
  const auto quarters = quarterTurns(angle);
  return quarters ? exact[static_cast<std::size_t>(*quarters)] : std::cos(angle);
}

double power(double base, double exponent) {
  const bool isSmallWhole = exponent == std::round(exponent) && std::abs(exponent) <= 16;
  if (!isSmallWhole) return finite(std::pow(base, exponent));
  double result = 1;
  for (int i = static_cast<int>(std::abs(exponent)); i > 0; --i) result *= base;
  return finite(exponent < 0 ? 1 / result : result);
}

double sweep(Point2 from, Point2 to) {
  if (from == Point2{} || to == Point2{}) return kNoValue;
  const double angle = std::atan2(cross(from, to), dot(from, to));
  return angle > 0 ? angle : angle + kTurn;
}

/// The sum of unit vectors is small near half a turn, their difference near a full one; each is
/// used where it is large.
Point2 bisect(Point2 from, Point2 to) {
  const double lengthFrom = length(from), lengthTo = length(to);
  if (lengthFrom == 0 || lengthTo == 0) return {kNoValue, kNoValue};
  const Point2 u = (1 / lengthFrom) * from, w = (1 / lengthTo) * to;
  Point2 result;
  if (dot(u, w) < 0) {
    const Point2 d = u - w;
    result = {-d.y, d.x};
  } else if (cross(u, w) == 0) {
    result = -1.0 * u;  // a full turn
  } else {
    result = cross(u, w) > 0 ? u + w : -1.0 * (u + w);
  }
  return (1 / length(result)) * result;
}

double both(double a, double b) {  // false wins over no value
  if (a == 0 || b == 0) return 0;
  return std::isnan(a) || std::isnan(b) ? kNoValue : 1;
}

double either(double a, double b) {
  if ((!std::isnan(a) && a != 0) || (!std::isnan(b) && b != 0)) return 1;
  return std::isnan(a) || std::isnan(b) ? kNoValue : 0;
}

/// One step of a run: the arguments are values of earlier steps.
class Runner {
 public:
  Runner(const AF2Binding& binding, std::span<const double> inputs, std::span<const double> values)
      : binding_(binding), inputs_(inputs), values_(values) {}

  double arithmetic(const Step& s) const {
    const double a = at(s, 0), b = at(s, 1);
    switch (s.op) {
      case Op::Add:
        return finite(a + b);
      case Op::Subtract:
        return finite(a - b);
      case Op::Multiply:
        return finite(a * b);
      case Op::Divide:
        return b == 0 ? kNoValue : finite(a / b);
      case Op::Negate:
        return -a;
      case Op::Power:
        return power(a, b);
      case Op::SquareRoot:
        return a < 0 ? kNoValue : std::sqrt(a);
      case Op::Sine:
        return sine(a);
      case Op::Cosine:
        return cosine(a);
      case Op::Tangent:
        return cosine(a) == 0 ? kNoValue : finite(sine(a) / cosine(a));
      case Op::Atan2:
        return a == 0 && b == 0 ? kNoValue : std::atan2(a, b);
      case Op::Absolute:
        return std::abs(a);
      case Op::Minimum:
        return std::isnan(a) || std::isnan(b) ? kNoValue : std::min(a, b);
      case Op::Maximum:
        return std::isnan(a) || std::isnan(b) ? kNoValue : std::max(a, b);
      case Op::Floor:
        return std::floor(a);
      case Op::Sweep:
        return sweep({a, b}, {at(s, 2), at(s, 3)});
      case Op::BisectX:
        return bisect({a, b}, {at(s, 2), at(s, 3)}).x;
      case Op::BisectY:
        return bisect({a, b}, {at(s, 2), at(s, 3)}).y;
      default:
        return logic(s, a, b);
    }
  }

  double surroundings(const Step& s) const {
    static const AF2Surroundings nothing;
    const AF2Surroundings& around = binding_.surroundings ? *binding_.surroundings : nothing;
    const Point2 p = s.arguments[0] < 0 ? Point2{} : Point2{at(s, 0), at(s, 1)};
    if (std::isnan(p.x) || std::isnan(p.y)) return kNoValue;
    switch (s.op) {
      case Op::Layer:
        return around.layer(s.index);
      case Op::OnBoundary:
        return truth(around.onBoundary(s.index));
      case Op::Valence:
        return around.valence(s.index);
      case Op::Turn:
        return around.turn(s.index).value_or(kNoValue);
      case Op::LoopSize:
        return around.loopSize();
      case Op::SizeAt:
        return finite(around.size(p));
      case Op::FrontDistance:
        return finite(around.distanceToFront(p));
      case Op::CurvatureAt:
        return finite(around.curvature(p));
      default:
        return kNoValue;
    }
  }

  double at(const Step& s, std::size_t i) const {
    return s.arguments[i] < 0 ? 0 : values_[static_cast<std::size_t>(s.arguments[i])];
  }

  Point2 vertex(int i) const {
    if (static_cast<std::size_t>(i) >= binding_.vertices.size())
      throw InputError("rule expression: the match has too few vertices");
    return binding_.vertices[static_cast<std::size_t>(i)];
  }

  double input(int i) const { return inputs_[static_cast<std::size_t>(i)]; }
  int level() const { return binding_.level; }

 private:
  double logic(const Step& s, double a, double b) const {
    switch (s.op) {
      case Op::And:
        return both(a, b);
      case Op::Or:
        return either(a, b);
      case Op::Select:
        return std::isnan(a) ? kNoValue : a != 0 ? b : at(s, 2);
      case Op::Not:
        return std::isnan(a) ? kNoValue : truth(a == 0);
      case Op::LeftTurn:
      case Op::NotRightTurn:
        return turns(s);
      default:
        break;
    }
    if (std::isnan(a) || std::isnan(b)) return kNoValue;
    switch (s.op) {
      case Op::Less:
        return truth(a < b);
      case Op::LessEqual:
        return truth(a <= b);
      case Op::Equal:
        return truth(a == b);
      default:
        return kNoValue;
    }
  }

  double turns(const Step& s) const {
    for (std::size_t i = 0; i < 6; ++i)
      if (std::isnan(at(s, i))) return kNoValue;
    const Turn turn = orientation({at(s, 0), at(s, 1)}, {at(s, 2), at(s, 3)}, {at(s, 4), at(s, 5)});
    return truth(s.op == Op::LeftTurn ? turn == Turn::Left : turn != Turn::Right);
  }

  const AF2Binding& binding_;
  std::span<const double> inputs_, values_;
};

bool isSurroundings(Op op) { return (op >= Op::Layer && op <= Op::CurvatureAt); }

}  // namespace

double evaluateStep(const Step& step, std::span<const double> values) {
  return Runner({}, {}, values).arithmetic(step);
}

int argumentCount(Op op) {
  switch (op) {
    case Op::SizeAt:
    case Op::FrontDistance:
    case Op::CurvatureAt:
      return 2;
    case Op::Add:
    case Op::Subtract:
    case Op::Multiply:
    case Op::Divide:
    case Op::Power:
    case Op::Atan2:
    case Op::Minimum:
    case Op::Maximum:
    case Op::Less:
    case Op::LessEqual:
    case Op::Equal:
    case Op::And:
    case Op::Or:
    case Op::Inside:
      return 2;
    case Op::Negate:
    case Op::SquareRoot:
    case Op::Sine:
    case Op::Cosine:
    case Op::Tangent:
    case Op::Absolute:
    case Op::Floor:
    case Op::Not:
      return 1;
    case Op::Select:
      return 3;
    case Op::Sweep:
    case Op::BisectX:
    case Op::BisectY:
      return 4;
    case Op::LeftTurn:
    case Op::NotRightTurn:
      return 6;
    default:
      return 0;
  }
}

bool Program::run(const AF2Binding& binding, std::span<const double> inputs,
                  std::span<double> results) const {
  constexpr std::size_t kUsual = 192;  // programs of rules have some dozens of steps
  std::array<double, kUsual> small;
  std::vector<double> large;
  double* values = small.data();
  if (steps_.size() > kUsual) {
    large.resize(steps_.size());
    values = large.data();
  }
  const Runner runner(binding, inputs, {values, steps_.size()});
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& s = steps_[i];
    if (isArithmetic(s.op))
      values[i] = runner.arithmetic(s);
    else if (isSurroundings(s.op))
      values[i] = runner.surroundings(s);
    else if (s.op == Op::Constant)
      values[i] = s.constant;
    else if (s.op == Op::CoordinateX)
      values[i] = runner.vertex(s.index).x;
    else if (s.op == Op::CoordinateY)
      values[i] = runner.vertex(s.index).y;
    else if (s.op == Op::Level)
      values[i] = runner.level();
    else if (s.op == Op::Input)
      values[i] = runner.input(s.index);
    else if (s.op == Op::Inside)
      values[i] = shapes_[static_cast<std::size_t>(s.index)]->holds(
          binding, {runner.at(s, 0), runner.at(s, 1)});
    else if (s.op == Op::Call)
      values[i] =
          finite(call(*functions_[static_cast<std::size_t>(s.index)], s.arguments, {values, i}));
    else
      throw InternalError("a rule with errors was run");
  }
  bool hasValues = true;
  for (std::size_t i = 0; i < results_.size(); ++i) {
    results[i] = values[results_[i]];
    hasValues = hasValues && !std::isnan(results[i]);
  }
  return hasValues;
}

}  // namespace af2::dsl
