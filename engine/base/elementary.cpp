#include "engine/base/elementary.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace af2 {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A quarter turn, and what is beyond its last digit.
constexpr double kQuarter = std::numbers::pi / 2, kQuarterRest = 0x1.1a62633145c07p-54;

/// log(2): multiples of the first part up to 2048 are exact.
constexpr double kLogOfTwo = 0x1.62e42fefa38p-1, kLogOfTwoRest = 0x1.ef35793c7673p-45;

/// The sum of c[i] x^i, even and odd powers side by side.
template <std::size_t kCount>
double polynomial(const std::array<double, kCount>& c, double x) {
  const double square = x * x;
  double even = 0, odd = 0;
  for (std::size_t i = kCount; i-- > 0;) {
    double& sum = i % 2 == 0 ? even : odd;
    sum = c[i] + square * sum;
  }
  return even + x * odd;
}

/// atan(z) = z + z^3 (c[0] + c[1] z^2 + ...), |z| <= 1/8
constexpr std::array kArcSeries{-1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9,
                                -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};

/// atan(k / 4), and what is beyond the last digit.
constexpr std::array kArcs{0.0, 0x1.f5b75f92c80ddp-3, 0x1.dac670561bb4fp-2, 0x1.4978fa3269ee1p-1,
                           0x1.921fb54442d18p-1};
constexpr std::array kArcRests{0.0, 0x1.8ab6e3cf7afbdp-57, 0x1.a2b7f222f65e2p-56,
                               0x1.2419a87f2a458p-56, 0x1.1a62633145c07p-55};

/// Of y / x, 0 <= y <= x > 0. The difference y - t x has no rounding error.
double arcTangent(double y, double x) {
  const double eighths = 8 * y;
  const int k = (eighths >= x) + (eighths >= 3 * x) + (eighths >= 5 * x) + (eighths >= 7 * x);
  const auto i = static_cast<std::size_t>(k);
  const double t = 0.25 * k;
  const double z = (y - t * x) / (x + t * y), square = z * z;
  return kArcs[i] + (z + (z * (square * polynomial(kArcSeries, square)) + kArcRests[i]));
}

/// sin(x) = x + x^3 (c[0] + c[1] x^2 + ...), |x| <= pi / 4
constexpr std::array kSineSeries{
    -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
    -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};

/// cos(x) = 1 - x^2 / 2 + x^4 (c[0] + c[1] x^2 + ...)
constexpr std::array kCosineSeries{
    1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
    1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};

double sineOfSmall(double x) {
  const double square = x * x;
  return x + x * (square * polynomial(kSineSeries, square));
}

double cosineOfSmall(double x) {
  const double square = x * x, half = square / 2, most = 1 - half;
  const double lost = (1 - most) - half;
  return most + (lost + square * square * polynomial(kCosineSeries, square));
}

/// A number to twice the digits.
struct Sum {
  double high, low;
};

Sum sumOf(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

Sum halvesOf(double x) {
  const double large = 0x1p27 * x + x, high = large - (large - x);
  return {high, x - high};
}

Sum productOf(double a, double b) {
  const Sum p = halvesOf(a), q = halvesOf(b);
  const double product = a * b;
  return {product, ((p.high * q.high - product) + p.high * q.low + p.low * q.high) + p.low * q.low};
}

/// log((1 + s) / (1 - s)) = 2 s + s^3 (c[0] + c[1] s^2 + ...), |s| <= 0.1716
constexpr std::array kLogSeries{2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11, 2.0 / 13,
                                2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21, 2.0 / 23};

/// A positive number as mantissa * 2^exponent, with a mantissa between the roots of 1/2 and 2.
struct Scaled {
  double mantissa = 0;
  int exponent = 0;
};

Scaled scaled(double x) {
  Scaled result;
  result.mantissa = std::frexp(x, &result.exponent);
  if (result.mantissa < std::numbers::sqrt2 / 2) {
    result.mantissa *= 2;
    --result.exponent;
  }
  return result;
}

Sum logarithmSum(double x) {
  const auto [mantissa, exponent] = scaled(x);
  const double f = mantissa - 1;
  const Sum divisor = sumOf(mantissa, 1);
  const double s = f / divisor.high, square = s * s;
  const Sum back = productOf(s, divisor.high);
  const double sRest = (((f - back.high) - back.low) - s * divisor.low) / divisor.high;
  const Sum first = sumOf(exponent * kLogOfTwo, 2 * s);
  const Sum both = sumOf(first.high, s * (square * polynomial(kLogSeries, square)));
  return {both.high,
          both.low + (first.low + (2 * sRest * (1 + square) + exponent * kLogOfTwoRest))};
}

/// exp(x) - 1 = x (1 + x/2 (1 + x/3 (...)))
double exponentialOfSum(Sum x) {
  constexpr double kLeast = -1500, kMost = 1500;  // of the exponents of 2
  constexpr int kTerms = 18;
  if (std::isnan(x.high)) return x.high;
  const double twos = std::round(x.high / std::numbers::ln2);
  if (twos > kMost) return kInfinity;
  if (twos < kLeast) return 0;
  const Sum rest = sumOf(x.high - twos * kLogOfTwo, x.low - twos * kLogOfTwoRest);
  double sum = 0;
  for (int i = kTerms; i >= 2; --i) sum = (sum + 1) * (rest.high / i);
  const Sum one = sumOf(1, rest.high);
  const double small = rest.high * sum + rest.low * (1 + rest.high);
  return std::ldexp(one.high + (one.low + small), static_cast<int>(twos));
}

/// Of a positive, finite base other than 1.
double positivePower(double base, double exponent) {
  constexpr double kMost = 1100;  // a number holds exp(709)
  const Sum log = logarithmSum(base);
  const double rough = log.high * exponent;
  if (std::abs(rough) > kMost) return rough > 0 ? kInfinity : 0;
  const Sum product = productOf(log.high, exponent);
  return exponentialOfSum(sumOf(product.high, product.low + log.low * exponent));
}

}  // namespace

Point2 directionAt(double angle) {
  if (!std::isfinite(angle)) return {kNoNumber, kNoNumber};
  double quarters = 0, rest = angle;
  if (std::abs(angle) > kQuarter / 2) {
    constexpr double kMostCounted = 0x1p40;
    rest = std::remainder(angle, kQuarter);  // without rounding error
    quarters = std::round((angle - rest) / kQuarter);
    if (std::abs(quarters) < kMostCounted) rest -= quarters * kQuarterRest;
  }
  const double c = cosineOfSmall(rest), s = sineOfSmall(rest);
  switch (static_cast<int>(std::fmod(quarters, 4)) & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

double angleOf(Point2 direction) {
  double x = std::abs(direction.x), y = std::abs(direction.y);
  const bool isSteep = y > x;
  if (isSteep) std::swap(x, y);
  if (!(x > 0)) return x + y;
  double angle = arcTangent(y, x);
  if (isSteep) angle = kQuarter - (angle - kQuarterRest);
  if (direction.x < 0) angle = 2 * kQuarter - (angle - 2 * kQuarterRest);
  return direction.y < 0 ? -angle : angle;
}

double logarithm(double x) {
  if (!(x > 0)) return x == 0 ? -kInfinity : kNoNumber;
  if (x == kInfinity) return x;
  const auto [mantissa, exponent] = scaled(x);
  const double f = mantissa - 1, s = f / (2 + f), square = s * s;
  const double beyond = s * (square * polynomial(kLogSeries, square) - f);  // 2 s = f - s f
  return exponent * kLogOfTwo + (f + (beyond + exponent * kLogOfTwoRest));
}

double exponential(double x) { return exponentialOfSum({x, 0}); }

double power(double base, double exponent) {
  if (exponent == 0 || base == 1) return 1;
  if (std::isnan(base) || std::isnan(exponent)) return kNoNumber;
  const double size = std::abs(base);
  if (base < 0 && std::trunc(exponent) != exponent) return kNoNumber;
  const bool isOdd = std::fmod(std::abs(exponent), 2) == 1;
  double result = 1;
  if (size == 0 || size == kInfinity)
    result = (size > 1) == (exponent > 0) ? kInfinity : 0;
  else if (size != 1)
    result = positivePower(size, exponent);
  return base < 0 && isOdd ? -result : result;
}

}  // namespace af2
