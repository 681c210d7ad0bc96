#include "engine/base/elementary.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

namespace af2 {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The difference in units of the last place.
double unitsOff(double value, long double exact) {
  int exponent = 0;
  std::frexp(static_cast<double>(exact), &exponent);
  return static_cast<double>(std::abs(value - exact) / std::ldexp(1.0L, exponent - 53));
}

/// The largest difference for many random numbers.
template <class Number, class Value, class Exact>
double mostOff(Number&& number, Value&& value, Exact&& exact) {
  double most = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = number();
    most = std::max(most, unitsOff(value(x), exact(static_cast<long double>(x))));
  }
  return most;
}

class Elementary : public testing::Test {
 protected:
  std::mt19937_64 random_{7};

  double within(double range) {
    return range * (2 * static_cast<double>(random_() >> 11) * 0x1p-53 - 1);
  }
};

TEST_F(Elementary, DirectionsAreRightToTheLastPlaces) {
  for (const double range : {0.8, 7.0, 1e3, 1e6}) {
    const auto angle = [&] { return within(range); };
    EXPECT_LT(mostOff(angle, sine, [](long double x) { return std::sin(x); }), 1.6) << range;
    EXPECT_LT(mostOff(angle, cosine, [](long double x) { return std::cos(x); }), 1.6) << range;
  }
  const auto steep = [&] { return within(1.5); };
  EXPECT_LT(mostOff(steep, tangent, [](long double x) { return std::tan(x); }), 4);
  EXPECT_EQ(sine(std::numbers::pi), 0x1.1a62633145c07p-53);
  EXPECT_EQ(cosine(0), 1);
  EXPECT_TRUE(std::isnan(sine(kInfinity)) && std::isnan(cosine(kNoNumber)));
  EXPECT_LE(std::abs(sine(1e300)), 1.0000001);
}

TEST_F(Elementary, AnglesAreRightToTheLastPlaces) {
  for (const double x : {1.0, -1.0})
    EXPECT_LT(mostOff([&] { return within(3); },
                      [&](double y) {
                        return angleOf({x, y});
                      },
                      [&](long double y) { return std::atan2(y, static_cast<long double>(x)); }),
              2);
  for (const double y : {1.0, -1.0})
    EXPECT_LT(mostOff([&] { return within(3); },
                      [&](double x) {
                        return angleOf({x, y});
                      },
                      [&](long double x) { return std::atan2(static_cast<long double>(y), x); }),
              2);
  EXPECT_EQ(angleOf({2, 0}), 0);
  EXPECT_EQ(angleOf({0, 2}), std::numbers::pi / 2);
  EXPECT_EQ(angleOf({-2, 0}), std::numbers::pi);
  EXPECT_EQ(angleOf({0, -2}), -std::numbers::pi / 2);
  EXPECT_EQ(angleOf({1e-310, 1e-310}), std::numbers::pi / 4);
  EXPECT_EQ(angleOf({0, 0}), 0);
  EXPECT_TRUE(std::isnan(angleOf({kNoNumber, 1})) && std::isnan(angleOf({1, kNoNumber})) &&
              std::isnan(angleOf({kNoNumber, 0})) && std::isnan(angleOf({0, kNoNumber})));
  EXPECT_EQ(angleBetween({0, 0, 2}, {0, 3, 3}), std::numbers::pi / 4);
  EXPECT_EQ(angleBetween({0, 0, 0}, {0, 3, 3}), 0);
}

TEST_F(Elementary, LogarithmsAndExponentialsAreRightToTheLastPlaces) {
  EXPECT_LT(mostOff([&] { return std::exp(within(700)); }, logarithm,
                    [](long double x) { return std::log(x); }),
            1.5);
  EXPECT_LT(mostOff([&] { return 1 + within(0.4); }, logarithm,
                    [](long double x) { return std::log(x); }),
            1.5);
  EXPECT_LT(
      mostOff([&] { return within(700); }, exponential, [](long double x) { return std::exp(x); }),
      1);
  EXPECT_EQ(logarithm(1), 0);
  EXPECT_EQ(logarithm(0), -kInfinity);
  EXPECT_EQ(logarithm(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(logarithm(-1)) && std::isnan(logarithm(kNoNumber)));
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(kInfinity), kInfinity);
  EXPECT_EQ(exponential(-kInfinity), 0);
  EXPECT_EQ(exponential(1e4), kInfinity);
  EXPECT_TRUE(std::isnan(exponential(kNoNumber)));
}

TEST_F(Elementary, PowersAreRightToTheLastPlaces) {
  for (const double exponent : {0.5, -0.5, 1.0 / 3, 17.0, -9.8, 61.25})
    EXPECT_LT(
        mostOff([&] { return std::exp(within(10)); }, [&](double x) { return power(x, exponent); },
                [&](long double x) { return std::pow(x, static_cast<long double>(exponent)); }),
        1)
        << exponent;
  for (const double base : {0.0, 1.0, -1.0, 2.0, -2.0, 0.25, -0.25, kInfinity})
    for (const double exponent :
         {0.0, 1.0, -1.0, 2.0, 3.0, -4.0, 0.5, -0.5, 1e4, -1e4, kInfinity, -kInfinity}) {
      const double expected = std::pow(base, exponent), found = power(base, exponent);
      EXPECT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected)))
          << base << " " << exponent << " " << found;
    }
  EXPECT_TRUE(std::isnan(power(kNoNumber, 2)) && std::isnan(power(2, kNoNumber)));
  EXPECT_EQ(power(kNoNumber, 0), 1);
}

/// What every machine is to compute: a rule set gives the same mesh there.
TEST_F(Elementary, TheBitsAreTheSameEverywhere) {
  std::uint64_t all = 0;
  const auto add = [&](double value) {
    all = all * 1099511628211U + std::bit_cast<std::uint64_t>(value);
  };
  for (int i = 0; i < 100000; ++i) {
    const double x = within(7), y = within(7);
    add(sine(x));
    add(cosine(x));
    add(tangent(x));
    add(angleOf({x, y}));
    add(logarithm(x * x));
    add(exponential(x));
    add(power(x * x, y));
  }
  EXPECT_EQ(all, 9497896970866311362U);
}

}  // namespace
}  // namespace af2
