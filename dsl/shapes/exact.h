// Exact signs of polynomials in doubles: first with running error bounds, then with dyadic numbers.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

#include "engine/base/point.h"

namespace af2::dsl::shapes {

/// A double with a bound on its accumulated error. An exact zero has a bound of zero, so that
/// shared corners, the most common degeneracy, are decided without the slow path.
class Bounded {
 public:
  Bounded(double value = 0, double error = 0) : value_(value), error_(error) {}

  double value() const { return value_; }
  double error() const { return error_; }
  bool isProven() const { return std::abs(value_) > error_ || (value_ == 0 && error_ == 0); }
  int sign() const { return (value_ > 0) - (value_ < 0); }

  friend Bounded operator+(Bounded a, Bounded b) { return sum(a, b, a.value_ + b.value_); }
  friend Bounded operator-(Bounded a, Bounded b) { return sum(a, b, a.value_ - b.value_); }
  friend Bounded operator*(Bounded a, Bounded b) {
    if (a.isZero() || b.isZero()) return {};
    const double value = a.value_ * b.value_;
    const double error = std::abs(a.value_) * b.error_ + std::abs(b.value_) * a.error_ +
                         a.error_ * b.error_ + kRounding * std::abs(value) + kUnderflow;
    return {value, kSlack * error};
  }

  /// Twice the unit roundoff: this covers the rounding of the bound itself.
  static constexpr double kRounding = 2.220446049250313e-16;
  static constexpr double kUnderflow = 1e-300;
  static constexpr double kSlack = 1 + 1e-12;

 private:
  bool isZero() const { return value_ == 0 && error_ == 0; }
  static Bounded sum(Bounded a, Bounded b, double value) {
    return {value, kSlack * (a.error_ + b.error_ + kRounding * std::abs(value))};
  }

  double value_, error_;
};

/// mantissa * 2^exponent with a mantissa of any length; sums and products are exact.
class Dyadic {
 public:
  Dyadic(double value = 0) {
    if (value == 0) return;
    mantissa_ = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent_), 53));
    exponent_ -= 53;
  }

  int sign() const { return mantissa_.sign(); }

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, false); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, true); }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic product;
    product.mantissa_ = a.mantissa_ * b.mantissa_;
    product.exponent_ = product.mantissa_ == 0 ? 0 : a.exponent_ + b.exponent_;
    return product;
  }

 private:
  static Dyadic sum(const Dyadic& a, const Dyadic& b, bool negateB) {
    if (b.mantissa_ == 0) return a;
    Dyadic result;
    result.exponent_ = a.mantissa_ == 0 ? b.exponent_ : std::min(a.exponent_, b.exponent_);
    if (a.mantissa_ != 0) result.mantissa_ = a.mantissa_ << (a.exponent_ - result.exponent_);
    const Integer shifted = b.mantissa_ << (b.exponent_ - result.exponent_);
    if (negateB)
      result.mantissa_ -= shifted;
    else
      result.mantissa_ += shifted;
    return result;
  }

  using Integer = boost::multiprecision::cpp_int;
  Integer mantissa_ = 0;
  int exponent_ = 0;
};

/// A vector of any number type.
template <class N>
struct Vector {
  N x{}, y{};
};

/// to - from, exact if N is exact.
template <class N>
Vector<N> difference(Point2 from, Point2 to) {
  return {N(to.x) - N(from.x), N(to.y) - N(from.y)};
}
template <class N>
N dot(const Vector<N>& p, const Vector<N>& q) {
  return p.x * q.x + p.y * q.y;
}
template <class N>
N cross(const Vector<N>& p, const Vector<N>& q) {
  return p.x * q.y - p.y * q.x;
}

/// The sign of `polynomial.operator()<N>()`, a polynomial in doubles, exactly.
template <class Polynomial>
int signOf(const Polynomial& polynomial) {
  const Bounded filtered = polynomial.template operator()<Bounded>();
  if (filtered.isProven()) return filtered.sign();
  return polynomial.template operator()<Dyadic>().sign();
}

/// The sign of a + b sqrt(radicand), radicand >= 0, from the signs of polynomials alone.
template <class N>
int signWithRoot(const N& a, const N& b, const N& radicand) {
  const int signA = a.sign();
  const int signB = radicand.sign() == 0 ? 0 : b.sign();
  if (signA == 0 || signB == 0 || signA == signB) return signA != 0 ? signA : signB;
  return signA * (a * a - b * b * radicand).sign();
}

}  // namespace af2::dsl::shapes
