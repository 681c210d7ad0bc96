#include "dsl/program/program.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dsl/program/registry.h"
#include "dsl/program/shape_program.h"
#include "dsl/program/steps.h"
#include "engine/base/elementary.h"
#include "engine/base/error.h"
#include "engine/base/predicates.h"
#include "engine/base/turn.h"

namespace af2::dsl {
namespace {

double finite(double x) { return std::isfinite(x) ? x : kNoValue; }
double truth(bool b) { return b ? 1.0 : 0.0; }

/// Quarter turns are exact, so that rot(v, 90deg) does not round coordinates.
std::optional<int> quarterTurns(double angle) {
  const double quarters = angle / (kFullTurn / 4);
  const double whole = std::round(quarters);
  // An angle without a value is not close to a quarter turn.
  const bool isNear = std::abs(quarters - whole) <= 1e-14 * std::max(1.0, std::abs(whole));
  if (!isNear || std::abs(whole) > 1e6) return std::nullopt;
  return ((static_cast<int>(whole) % 4) + 4) % 4;
}

double sine(double angle) {
  constexpr std::array<double, 4> exact{0, 1, 0, -1};
  const auto quarters = quarterTurns(angle);
  return quarters ? exact[static_cast<std::size_t>(*quarters)] : af2::sine(angle);
}

double cosine(double angle) {
  constexpr std::array<double, 4> exact{1, 0, -1, 0};
  const auto quarters = quarterTurns(angle);
  return quarters ? exact[static_cast<std::size_t>(*quarters)] : af2::cosine(angle);
}

double power(double base, double exponent) {
  const bool isSmallWhole = exponent == std::round(exponent) && std::abs(exponent) <= 16;
  if (!isSmallWhole) return finite(af2::power(base, exponent));
  double result = 1;
  for (int i = static_cast<int>(std::abs(exponent)); i > 0; --i) result *= base;
  return finite(exponent < 0 ? 1 / result : result);
}

double sweep(Point2 from, Point2 to) {
  if (from == Point2{} || to == Point2{}) return kNoValue;
  return turnBetween(from, to);
}

/// The sum of the unit vectors is small near a half turn, and their difference is small near a full
/// turn. The larger one is used, because it has the smaller relative error.
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

double both(double a, double b) {  // a false operand decides, even if the other has no value
  if (a == 0 || b == 0) return 0;
  return std::isnan(a) || std::isnan(b) ? kNoValue : 1;
}

double either(double a, double b) {
  if ((!std::isnan(a) && a != 0) || (!std::isnan(b) && b != 0)) return 1;
  return std::isnan(a) || std::isnan(b) ? kNoValue : 0;
}

double chosen(double condition, double a, double b) {
  return std::isnan(condition) ? kNoValue : condition != 0 ? a : b;
}

/// Evaluates one step; its arguments are values of earlier steps.
class Runner {
 public:
  Runner(const AF2Binding& binding, std::span<const double> inputs, const double* values)
      : binding_(binding), inputs_(inputs), values_(values) {}

  /// The value of a step that needs only values, or only the match. The most frequent operations
  /// are in one switch, because the dispatch is the main cost of a step.
  double operator()(const Step& s) const {
    const auto at = [&](std::size_t i) { return values_[s.arguments[i]]; };
    switch (s.op) {
      case Op::Constant:
        return s.constant;
      case Op::CoordinateX:
        return vertex(s.index).x;
      case Op::CoordinateY:
        return vertex(s.index).y;
      case Op::Level:
        return binding_.level;
      case Op::Input:
        return inputs_[static_cast<std::size_t>(s.index)];
      case Op::Add:
        return finite(at(0) + at(1));
      case Op::Subtract:
        return finite(at(0) - at(1));
      case Op::Multiply:
        return finite(at(0) * at(1));
      case Op::Divide:
        return at(1) == 0 ? kNoValue : finite(at(0) / at(1));
      case Op::Negate:
        return -at(0);
      case Op::Power:
        return power(at(0), at(1));
      case Op::SquareRoot:
        return at(0) < 0 ? kNoValue : std::sqrt(at(0));
      case Op::Sine:
        return sine(at(0));
      case Op::Cosine:
        return cosine(at(0));
      case Op::Tangent:
        return cosine(at(0)) == 0 ? kNoValue : finite(sine(at(0)) / cosine(at(0)));
      case Op::Atan2:
        return at(0) == 0 && at(1) == 0 ? kNoValue : af2::angleOf({at(1), at(0)});
      case Op::Absolute:
        return std::abs(at(0));
      case Op::Minimum:
        return isUnknown(at(0), at(1)) ? kNoValue : std::min(at(0), at(1));
      case Op::Maximum:
        return isUnknown(at(0), at(1)) ? kNoValue : std::max(at(0), at(1));
      case Op::Sweep:
        return sweep({at(0), at(1)}, {at(2), at(3)});
      case Op::BisectX:
        return bisect({at(0), at(1)}, {at(2), at(3)}).x;
      case Op::BisectY:
        return bisect({at(0), at(1)}, {at(2), at(3)}).y;
      case Op::Less:
        return isUnknown(at(0), at(1)) ? kNoValue : truth(at(0) < at(1));
      case Op::LessEqual:
        return isUnknown(at(0), at(1)) ? kNoValue : truth(at(0) <= at(1));
      case Op::Equal:
        return isUnknown(at(0), at(1)) ? kNoValue : truth(at(0) == at(1));
      case Op::And:
        return both(at(0), at(1));
      case Op::Or:
        return either(at(0), at(1));
      case Op::Not:
        return std::isnan(at(0)) ? kNoValue : truth(at(0) == 0);
      case Op::Select:
        return chosen(at(0), at(1), at(2));
      case Op::LeftTurn:
      case Op::NotRightTurn:
        return turns(s);
      case Op::Layer:
      case Op::OnBoundary:
      case Op::Valence:
      case Op::IsFixed:
      case Op::SizeOf:
      case Op::BeforeX:
      case Op::BeforeY:
      case Op::AfterX:
      case Op::AfterY:
      case Op::Turn:
      case Op::TurnOrStraight:
      case Op::Count:
      case Op::LoopSize:
      case Op::SizeAt:
      case Op::FrontDistance:
      case Op::CurvatureAt:
        return surroundings(s);
      case Op::Unknown:
      case Op::Inside:  // the program runs this and Call, because it has the shapes and functions
      case Op::Call:
        break;
    }
    throw InternalError("a rule with errors was run");
  }

 private:
  static bool isUnknown(double a, double b) { return std::isnan(a) || std::isnan(b); }

  static Point2 orNone(const std::optional<Point2>& point) {
    return point.value_or(Point2{kNoValue, kNoValue});
  }

  double surroundings(const Step& s) const {
    static const AF2Surroundings nothing;
    const AF2Surroundings& around = binding_.surroundings ? *binding_.surroundings : nothing;
    if (s.op == Op::Count)
      return around.count(
          s.index, {values_[s.arguments[0]], values_[s.arguments[1]], values_[s.arguments[2]]});
    const Point2 p =
        s.arguments[0] < 0 ? Point2{} : Point2{values_[s.arguments[0]], values_[s.arguments[1]]};
    if (isUnknown(p.x, p.y)) return kNoValue;
    switch (s.op) {
      case Op::Layer:
        return around.layer(s.index);
      case Op::OnBoundary:
        return truth(around.onBoundary(s.index));
      case Op::Valence:
        return around.valence(s.index);
      case Op::IsFixed:
        return truth(around.isFixed(s.index));
      case Op::SizeOf:
        return finite(around.sizeOf(s.index));
      case Op::BeforeX:
        return orNone(around.before(s.index)).x;
      case Op::BeforeY:
        return orNone(around.before(s.index)).y;
      case Op::AfterX:
        return orNone(around.after(s.index)).x;
      case Op::AfterY:
        return orNone(around.after(s.index)).y;
      case Op::Turn:
        return around.turn(s.index).value_or(kNoValue);
      case Op::TurnOrStraight:
        return around.turn(s.index).value_or(kFullTurn / 2);
      case Op::LoopSize:
        return around.loopSize();
      case Op::SizeAt:
        return finite(around.size(p));
      case Op::FrontDistance:
        return finite(around.distanceToFront(p));
      case Op::CurvatureAt:
        return finite(around.curvature(p));
      default:
        throw InternalError("a rule with errors was run");
    }
  }

  double turns(const Step& s) const {
    std::array<double, 6> c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = values_[s.arguments[i]];
    if (std::ranges::any_of(c, [](double x) { return std::isnan(x); })) return kNoValue;
    const Turn turn = orientation({c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]});
    return truth(s.op == Op::LeftTurn ? turn == Turn::Left : turn != Turn::Right);
  }

  Point2 vertex(int i) const {
    if (static_cast<std::size_t>(i) >= binding_.vertices.size())
      throw InputError("rule expression: the match has too few vertices");
    return binding_.vertices[static_cast<std::size_t>(i)];
  }

  const AF2Binding& binding_;
  std::span<const double> inputs_;
  const double* values_;
};

}  // namespace

double evaluateStep(const Step& step, std::span<const double> values) {
  return Runner({}, {}, values.data())(step);
}

bool Program::run(const AF2Binding& binding, std::span<const double> inputs,
                  std::span<double> results) const {
  constexpr std::size_t kUsual = 192;  // programs of rules usually have some dozens of steps
  std::array<double, kUsual> small;
  std::vector<double> large;
  double* values = small.data();
  if (steps_.size() > kUsual) {
    large.resize(steps_.size());
    values = large.data();
  }
  const Runner runner(binding, inputs, values);
  const auto holdsOrCalls = [&](const Step& s) {
    const auto index = static_cast<std::size_t>(s.index);
    if (s.op == Op::Inside)
      return shapes_[index]->holds(binding, {values[s.arguments[0]], values[s.arguments[1]]});
    return finite(call(*functions_[index], s.arguments, {values, steps_.size()}));
  };
  double* value = values;
  static_assert(std::ranges::none_of(kOperations, [](const Operation& o) {
    return o.op != Op::Unknown && (o.op >= Op::Inside) != (o.needs == Needs::Program);
  }));
  for (const Step& s : steps_) *value++ = s.op >= Op::Inside ? holdsOrCalls(s) : runner(s);
  bool hasValues = true;
  for (std::size_t i = 0; i < results_.size(); ++i) {
    results[i] = values[results_[i]];
    hasValues = hasValues && !std::isnan(results[i]);
  }
  return hasValues;
}

}  // namespace af2::dsl
