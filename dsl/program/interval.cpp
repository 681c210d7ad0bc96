#include "dsl/program/interval.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/elementary.h"

namespace af2::dsl {
namespace {

constexpr double kPi = std::numbers::pi;

/// Bounds below and above every number that rounds to x; `units` times as wide for functions with
/// larger rounding errors.
double below(double x, int units = 1) {
  return x - units * (std::abs(x) * 0x1p-52 + std::numeric_limits<double>::denorm_min());
}
double above(double x, int units = 1) {
  return x + units * (std::abs(x) * 0x1p-52 + std::numeric_limits<double>::denorm_min());
}

Interval outwards(double low, double high, int units = 1) {
  if (std::isnan(low) || std::isnan(high)) return Interval::all();
  return {std::isinf(low) ? low : below(low, units), std::isinf(high) ? high : above(high, units)};
}

/// A bound of the error of elementary functions (engine/base/elementary.h), in units of the last
/// digit.
constexpr int kLibraryUnits = 4;

/// Whether the interval contains some x0 + 2 pi k, within rounding.
bool holdsAngle(Interval a, double x0) {
  constexpr double kRounding = 1e-9;
  const double turns = std::ceil((a.low - kRounding - x0) / (2 * kPi));
  return x0 + 2 * kPi * turns <= a.high + kRounding;
}

}  // namespace

bool Interval::isFinite() const { return std::isfinite(low) && std::isfinite(high); }

Interval operator+(Interval a, Interval b) {
  if (a.isZero()) return b;
  if (b.isZero()) return a;
  return outwards(a.low + b.low, a.high + b.high);
}

Interval operator-(Interval a) { return {-a.high, -a.low}; }

Interval operator-(Interval a, Interval b) { return a + -b; }

Interval operator*(Interval a, Interval b) {
  if (a.isZero() || b.isZero()) return {};
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  if (std::isnan(p) || std::isnan(q) || std::isnan(r) || std::isnan(s)) return Interval::all();
  return outwards(std::min({p, q, r, s}), std::max({p, q, r, s}));
}

Interval operator/(Interval a, Interval b) {
  if (b.contains(0)) return Interval::all();
  if (a.isZero()) return {};
  const double p = a.low / b.low, q = a.low / b.high, r = a.high / b.low, s = a.high / b.high;
  if (std::isnan(p) || std::isnan(q) || std::isnan(r) || std::isnan(s)) return Interval::all();
  return outwards(std::min({p, q, r, s}), std::max({p, q, r, s}));
}

Interval hull(Interval a, Interval b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

Interval common(Interval a, Interval b) {
  const Interval both{std::max(a.low, b.low), std::min(a.high, b.high)};
  return both.low <= both.high ? both : a;
}

Interval squareRoot(Interval a) {
  if (a.high < 0) return Interval::all();
  const Interval root = outwards(std::sqrt(std::max(a.low, 0.0)), std::sqrt(a.high));
  return {std::max(root.low, 0.0), root.high};
}

Interval cosine(Interval a) {
  if (!a.isFinite() || a.width() >= 2 * kPi) return {-1, 1};
  const double p = af2::cosine(a.low), q = af2::cosine(a.high);
  Interval result = outwards(std::min(p, q), std::max(p, q), kLibraryUnits);
  // Programs round angles close to quarter turns to exact ones, which moves them a little.
  const double moved = 2e-14 * std::max(1.0, std::max(std::abs(a.low), std::abs(a.high)));
  result = {result.low - moved, result.high + moved};
  if (holdsAngle(a, 0)) result.high = 1;
  if (holdsAngle(a, kPi)) result.low = -1;
  return {std::max(result.low, -1.0), std::min(result.high, 1.0)};
}

Interval sine(Interval a) { return cosine(a - outwards(kPi / 2, kPi / 2)); }

Interval absolute(Interval a) {
  if (a.low >= 0) return a;
  if (a.high <= 0) return -a;
  return {0, std::max(-a.low, a.high)};
}

Interval minimum(Interval a, Interval b) {
  return {std::min(a.low, b.low), std::min(a.high, b.high)};
}

Interval maximum(Interval a, Interval b) {
  return {std::max(a.low, b.low), std::max(a.high, b.high)};
}

Interval wholePower(Interval a, int exponent) {
  if (exponent < 0) return Interval::point(1) / wholePower(a, -exponent);
  Interval result = Interval::point(1);
  const Interval base = exponent % 2 == 0 ? absolute(a) : a;
  for (int i = 0; i < exponent; ++i) result = result * base;
  return result;
}

Interval power(Interval a, Interval exponent) {
  if (!(a.low > 0) || !a.isFinite() || !exponent.isFinite()) return Interval::all();
  const double p = af2::power(a.low, exponent.low), q = af2::power(a.low, exponent.high),
               r = af2::power(a.high, exponent.low), s = af2::power(a.high, exponent.high);
  return outwards(std::min({p, q, r, s}), std::max({p, q, r, s}), kLibraryUnits);
}

Interval angleOf(Interval y, Interval x) {
  const Interval all = outwards(-kPi, kPi, kLibraryUnits);
  if (!x.isFinite() || !y.isFinite()) return all;
  if (x.low <= 0 && y.contains(0)) return all;  // around the origin, or across the cut
  const double p = af2::angleOf({x.low, y.low}), q = af2::angleOf({x.high, y.low}),
               r = af2::angleOf({x.low, y.high}), s = af2::angleOf({x.high, y.high});
  return outwards(std::min({p, q, r, s}), std::max({p, q, r, s}), kLibraryUnits);
}

}  // namespace af2::dsl
