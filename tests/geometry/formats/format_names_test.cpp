#include "geometry/formats/format_names.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>

#include "geometry/formats/column_numbers.h"

namespace af2::geometry {
namespace {

TEST(FormatNames, BecomeWordsThatDifferWithoutCapitals) {
  FormatNames names({12, true});
  EXPECT_EQ(names.add("lid (layer)"), "lid_layer");
  EXPECT_EQ(names.add("Lid  layer"), "Lid_layer_2");
  EXPECT_EQ(names.add("3"), "group_3");
  EXPECT_EQ(names.add("\u00e4"), "group_");
  EXPECT_EQ(names.add("a very long name"), "a_very_long_");
  EXPECT_EQ(names.add("a very long one"), "a_very_lon_2");
}

TEST(FormatNames, KeepWhatTheFormatHolds) {
  FormatNames names({5, false});
  EXPECT_EQ(names.add("a (b)"), "a (b)");
  EXPECT_EQ(names.add("a/b"), "a_b");
  EXPECT_EQ(names.add("abcd\u00e4"), "abcd");  // between characters
}

TEST(ColumnNumbers, AreExactIfTheyFit) {
  EXPECT_EQ(numberInColumns(0.1, 20), "0.1");
  EXPECT_EQ(nastranNumber(1, 16), "1.");
  EXPECT_EQ(nastranNumber(-1.5e-7, 16), "-1.5-7");
  EXPECT_EQ(nastranNumber(1e20, 16), "1.+20");
}

TEST(ColumnNumbers, LoseLastDigitsIfTheyDoNot) {
  for (const double value : {-1.0 / 3, 2.0 / 3e-7, -1.2345678901234567e-5, 1.2345678901234567e-200,
                             123456789012.3456789, 0.000123456789012345678}) {
    const std::string text = numberInColumns(value, 20);
    EXPECT_LE(text.size(), 20u) << text;
    EXPECT_NEAR(std::strtod(text.c_str(), nullptr) / value, 1, 1e-12) << text;
    std::string nastran = nastranNumber(value, 16);
    EXPECT_LE(nastran.size(), 16u) << nastran;
    EXPECT_NE(nastran.find('.'), std::string::npos) << nastran;
    const std::size_t sign = nastran.find_last_of("+-");
    if (sign != std::string::npos && sign > 0) nastran.insert(sign, "e");
    EXPECT_NEAR(std::strtod(nastran.c_str(), nullptr) / value, 1, 1e-9) << nastran;
  }
}

/// The form with more digits that one would find by trying all.
std::string longestInColumns(double value, std::size_t columns) {
  for (int digits = 17; digits > 1; --digits)
    for (const auto& [format, precision] : {std::pair(std::chars_format::general, digits),
                                            std::pair(std::chars_format::scientific, digits - 1)}) {
      char text[400];
      const auto end = std::to_chars(text, text + sizeof text, value, format, precision).ptr;
      if (static_cast<std::size_t>(end - text) <= columns) return {text, end};
    }
  return "";
}

TEST(ColumnNumbers, KeepAsManyDigitsAsFit) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  for (int i = 0; i < 20'000; ++i) {
    const double value = mantissa(random) * std::pow(10, i % 40 - 20);
    for (const std::size_t columns : {16u, 20u}) {
      const std::string text = numberInColumns(value, columns);
      if (std::strtod(text.c_str(), nullptr) == value) continue;
      EXPECT_EQ(text, longestInColumns(value, columns));
    }
  }
}

}  // namespace
}  // namespace af2::geometry
