#include "dsl/program/box_run.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/turn.h"

namespace af2::dsl {
namespace {

constexpr Interval kOne{1, 1}, kTruth{0, 1}, kUnit{-1, 1};

/// A value, with its derivatives with respect to the arguments of the step.
struct Local {
  Interval value;
  std::array<Interval, 4> by{};
};

Local jump(Interval value) {
  Local local{value};
  if (!value.isPoint()) local.by.fill(Interval::all());
  return local;
}

Local truth(bool isSurelyTrue, bool isSurelyFalse) {
  return jump(isSurelyTrue ? kOne : isSurelyFalse ? Interval{} : kTruth);
}

/// Bounds of the full angle 2 pi, with a margin for rounding on both sides.
Interval turned(Interval angle, double by) {
  return angle + Interval{by * (1 - 1e-15), by * (1 + 1e-15)};
}

/// A vector of unit length as a function of (x, y): its coordinates, and the derivatives of both.
struct Direction {
  Interval x, y, xx, xy, yy;  // xy: derivative of x by y, and of y by x
};

Direction directionOf(Interval x, Interval y) {
  const Interval size = squareRoot(wholePower(x, 2) + wholePower(y, 2));
  const Interval cube = wholePower(size, 3);
  return {common(x / size, kUnit), common(y / size, kUnit), wholePower(y, 2) / cube,
          -(x * y) / cube, wholePower(x, 2) / cube};
}

/// Cross and dot product of two vectors, from which the angle between them follows.
struct Spread {
  Interval cross, dot;
  Spread(const std::array<Interval, 4>& a)
      : cross(a[0] * a[3] - a[1] * a[2]), dot(a[0] * a[2] + a[1] * a[3]) {}
};

Local sweep(const std::array<Interval, 4>& a) {
  const Spread spread(a);
  Local local;
  if (spread.cross.low > 0)
    local.value = angleOf(spread.cross, spread.dot);
  else if (spread.cross.high < 0)
    local.value = turned(angleOf(spread.cross, spread.dot), kFullTurn);
  else if (spread.dot.high < 0)
    local.value = turned(angleOf(-spread.cross, -spread.dot), kFullTurn / 2);
  else
    return jump({0, kFullTurn + 1e-14});
  // The angle increases with the direction of `to` and decreases with the direction of `from`.
  const Interval from = wholePower(a[0], 2) + wholePower(a[1], 2);
  const Interval to = wholePower(a[2], 2) + wholePower(a[3], 2);
  local.by = {a[1] / from, -a[0] / from, -a[3] / to, a[2] / to};
  return local;
}

/// The unit vector halfway between two directions, counter-clockwise from the first one.
Local bisect(const std::array<Interval, 4>& a, bool wantsX) {
  const Spread spread(a);
  const Direction u = directionOf(a[0], a[1]), w = directionOf(a[2], a[3]);
  const bool isWide = spread.dot.high < 0;
  if (!isWide && spread.cross.contains(0)) return jump(kUnit);
  // Either the sum of both, turned to the correct side, or the perpendicular of their difference.
  const double sign = isWide || spread.cross.low > 0 ? 1 : -1;
  const Interval s = Interval::point(sign);
  const Interval x = isWide ? w.y - u.y : s * (u.x + w.x);
  const Interval y = isWide ? u.x - w.x : s * (u.y + w.y);
  const Direction half = directionOf(x, y);
  // Derivatives of (x, y) by the four coordinates.
  const std::array<Interval, 4> dx = isWide ? std::array{-u.xy, -u.yy, w.xy, w.yy}
                                            : std::array{s * u.xx, s * u.xy, s * w.xx, s * w.xy};
  const std::array<Interval, 4> dy = isWide ? std::array{u.xx, u.xy, -w.xx, -w.xy}
                                            : std::array{s * u.xy, s * u.yy, s * w.xy, s * w.yy};
  Local local{wantsX ? half.x : half.y};
  for (std::size_t i = 0; i < 4; ++i)
    local.by[i] = wantsX ? half.xx * dx[i] + half.xy * dy[i] : half.xy * dx[i] + half.yy * dy[i];
  return local;
}

Local powerOf(Interval a, Interval b) {
  const bool isWhole = b.isPoint() && b.low == std::round(b.low) && std::abs(b.low) <= 16;
  if (isWhole) {
    const int n = static_cast<int>(b.low);
    Local local{wholePower(a, n)};
    local.by[0] = n == 0 ? Interval{} : Interval::point(n) * wholePower(a, n - 1);
    return local;
  }
  Local local{power(a, b)};
  local.by = {b * power(a, b - kOne), Interval::all(), {}, {}};
  return local;
}

Local selected(Interval condition, Interval yes, Interval no) {
  if (!condition.contains(0)) return {yes, {Interval{}, kOne, Interval{}, Interval{}}};
  if (condition.isZero()) return {no, {Interval{}, Interval{}, kOne, Interval{}}};
  return jump(hull(yes, no));
}

Local absoluteOf(Interval a) {
  const Interval by = a.low >= 0 ? kOne : a.high <= 0 ? -kOne : kUnit;
  return {absolute(a), {by, {}, {}, {}}};
}

/// The smaller one where `sign` is 1, the larger one where it is -1.
Local extremeOf(Interval a, Interval b, bool wantsLeast) {
  const Interval share = Interval{0, 1};
  Local local{wantsLeast ? minimum(a, b) : maximum(a, b), {share, share, {}, {}}};
  const bool isFirst = wantsLeast ? a.high < b.low : a.low > b.high;
  const bool isSecond = wantsLeast ? b.high < a.low : b.low > a.high;
  if (isFirst) local.by = {kOne, Interval{}, {}, {}};
  if (isSecond) local.by = {Interval{}, kOne, {}, {}};
  return local;
}

/// Logic over 0 and 1; anything else but 0 counts as true.
Interval asTruth(Interval a) {
  if (a.isZero()) return {};
  return a.contains(0) ? kTruth : kOne;
}

Local localOf(const Step& step, const std::array<Interval, 4>& a) {
  constexpr double kMany = 1e9;
  switch (step.op) {
    case Op::Constant:
      return {std::isnan(step.constant) ? Interval::all() : Interval::point(step.constant)};
    case Op::Layer:
    case Op::Valence:
    case Op::LoopSize:
      return jump({0, kMany});
    case Op::Count:
      return jump({0, 5});
    case Op::OnBoundary:
    case Op::IsFixed:
    case Op::LeftTurn:
    case Op::NotRightTurn:
    case Op::Inside:
      return jump(kTruth);
    case Op::Turn:
    case Op::TurnOrStraight:
      return jump({0, kFullTurn + 1e-14});
    case Op::SizeOf:
    case Op::SizeAt:
    case Op::FrontDistance:
    case Op::CurvatureAt:
      return jump({0, Interval::kInfinity});
    case Op::Add:
      return {a[0] + a[1], {kOne, kOne, {}, {}}};
    case Op::Subtract:
      return {a[0] - a[1], {kOne, -kOne, {}, {}}};
    case Op::Negate:
      return {-a[0], {-kOne, {}, {}, {}}};
    case Op::Multiply: {
      const bool isSquare = step.arguments[0] == step.arguments[1];
      return {isSquare ? wholePower(a[0], 2) : a[0] * a[1], {a[1], a[0], {}, {}}};
    }
    case Op::Divide: {
      const Interval ratio = a[0] / a[1];
      return {ratio, {kOne / a[1], -ratio / a[1], {}, {}}};
    }
    case Op::Power:
      return powerOf(a[0], a[1]);
    case Op::SquareRoot: {
      const Interval root = squareRoot(a[0]);
      return {root, {a[0].low > 0 ? kOne / (root + root) : Interval::all(), {}, {}, {}}};
    }
    case Op::Sine:
      return {sine(a[0]), {cosine(a[0]), {}, {}, {}}};
    case Op::Cosine:
      return {cosine(a[0]), {-sine(a[0]), {}, {}, {}}};
    case Op::Tangent: {
      const Interval value = sine(a[0]) / cosine(a[0]);
      return {value, {kOne + wholePower(value, 2), {}, {}, {}}};
    }
    case Op::Atan2: {
      const Interval size = wholePower(a[0], 2) + wholePower(a[1], 2);
      const bool hasCut = a[1].low <= 0 && a[0].contains(0);
      if (hasCut) return jump(angleOf(a[0], a[1]));
      return {angleOf(a[0], a[1]), {a[1] / size, -a[0] / size, {}, {}}};
    }
    case Op::Absolute:
      return absoluteOf(a[0]);
    case Op::Minimum:
    case Op::Maximum:
      return extremeOf(a[0], a[1], step.op == Op::Minimum);
    case Op::Sweep:
      return sweep(a);
    case Op::BisectX:
    case Op::BisectY:
      return bisect(a, step.op == Op::BisectX);
    case Op::Less:
      return truth(a[0].high < a[1].low, a[0].low >= a[1].high);
    case Op::LessEqual:
      return truth(a[0].high <= a[1].low, a[0].low > a[1].high);
    case Op::Equal:
      return truth(a[0].isPoint() && a[0] == a[1], a[0].high < a[1].low || a[0].low > a[1].high);
    case Op::And:
      return jump(minimum(asTruth(a[0]), asTruth(a[1])));
    case Op::Or:
      return jump(maximum(asTruth(a[0]), asTruth(a[1])));
    case Op::Not:
      return truth(a[0].isZero(), !a[0].contains(0));
    case Op::Select:
      return selected(a[0], a[1], a[2]);
    // The box contains the bounds of its variables; nothing is known about other values.
    case Op::Unknown:
    case Op::CoordinateX:
    case Op::CoordinateY:
    case Op::Level:
    case Op::Input:
    case Op::BeforeX:
    case Op::BeforeY:
    case Op::AfterX:
    case Op::AfterY:
    case Op::Call:
      break;
  }
  return jump(Interval::all());
}

}  // namespace

Interval boundsOf(const Step& step, const std::array<Interval, 4>& arguments) {
  return localOf(step, arguments).value;
}

BoxRun::BoxRun(const Program& program, std::span<const BoxVariable> variables)
    : program_(program), variables_(variables.size()), variableOf_(program.stepCount(), -1) {
  values_.resize(program.stepCount());
  middles_.resize(program.stepCount());
  slopes_.resize(program.stepCount() * variables_);
  for (std::size_t s = 0; s < program.stepCount(); ++s) {
    const Step& step = program.steps()[s];
    for (std::size_t v = 0; v < variables_; ++v)
      if (variables[v].op == step.op && variables[v].vertex == step.index)
        variableOf_[s] = static_cast<int>(v);
  }
}

void BoxRun::run(const Box& box) {
  box_ = box;
  for (std::size_t s = 0; s < program_.stepCount(); ++s) bound(s);
}

void BoxRun::bound(std::size_t s) {
  const auto slopes = std::span(slopes_).subspan(s * variables_, variables_);
  std::ranges::fill(slopes, Interval{});
  if (variableOf_[s] >= 0) {
    const auto v = static_cast<std::size_t>(variableOf_[s]);
    values_[s] = box_[v];
    middles_[s] = Interval::point(box_[v].middle());
    slopes[v] = kOne;
    return;
  }
  const Step& step = program_.steps()[s];
  std::array<Interval, 4> values{}, middles{};
  for (std::size_t i = 0; i < 4 && step.arguments[i] >= 0; ++i) {
    values[i] = values_[static_cast<std::size_t>(step.arguments[i])];
    middles[i] = middles_[static_cast<std::size_t>(step.arguments[i])];
  }
  const Local local = localOf(step, values);
  values_[s] = local.value;
  middles_[s] = localOf(step, middles).value;
  Interval centred = middles_[s];
  for (std::size_t v = 0; v < variables_; ++v) {
    for (std::size_t i = 0; i < 4 && step.arguments[i] >= 0; ++i) {
      const auto argument = static_cast<std::size_t>(step.arguments[i]);
      slopes[v] = slopes[v] + local.by[i] * slopes_[argument * variables_ + v];
    }
    if (!slopes[v].isZero())
      centred = centred + slopes[v] * (box_[v] - Interval::point(box_[v].middle()));
  }
  values_[s] = common(values_[s], centred);
}

Interval BoxRun::differenceOf(std::size_t p, double factor, std::size_t q) const {
  const Interval f = Interval::point(factor);
  Interval result = middles_[p] - f * middles_[q];
  for (std::size_t v = 0; v < variables_; ++v)
    result =
        result + (slope(p, v) - f * slope(q, v)) * (box_[v] - Interval::point(box_[v].middle()));
  return result;
}

}  // namespace af2::dsl
