#include "geometry/formats/column_numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/base/elementary.h"

namespace af2::geometry {
namespace {

constexpr int kMostDigits = 17;

std::string shortest(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string withDigits(double value, std::chars_format form, int precision) {
  char text[400];
  return {text, std::to_chars(text, text + sizeof text, value, form, precision).ptr};
}

/// "1e-05" becomes "1.-5".
std::string asNastran(const std::string& number) {
  const std::size_t e = number.find('e');
  std::string digits = number.substr(0, e);
  if (digits.find('.') == std::string::npos) digits += '.';
  if (e == std::string::npos) return digits;
  const std::size_t first = number.find_first_not_of('0', e + 2);
  return digits + number[e + 1] + (first == std::string::npos ? "0" : number.substr(first));
}

std::string asItIs(const std::string& number) { return number; }

/// No more digits of a number fit, unless the last ones are zeros, and then less do as well.
int mostDigits(double value, std::size_t columns, std::string (*form)(const std::string&)) {
  // What does not depend on the number of digits: sign, point, exponent, and zeros after the point.
  const std::string one = form(withDigits(value, std::chars_format::scientific, 0));
  const std::size_t point = one.find('.') == std::string::npos ? 1 : 0;
  const std::size_t ofScientific = one.size() - 1 + point;
  const double size = std::abs(value);
  const std::size_t sign = value < 0 ? 1 : 0;
  // Digits that end before the point may do without it.
  const bool mayEndBefore = size >= power(10, static_cast<double>(columns) - 2);
  std::size_t ofFixed = sign + (mayEndBefore ? 0 : 1);
  for (double place = 1; place > size && ofFixed < ofScientific; place /= 10) ++ofFixed;
  const std::size_t least = std::min(ofScientific, ofFixed);
  return columns > least ? std::min(kMostDigits, static_cast<int>(columns - least)) : 1;
}

std::string inColumns(double value, std::size_t columns, std::string (*form)(const std::string&)) {
  const std::string exact = form(shortest(value));
  if (exact.size() <= columns) return exact;
  for (int digits = mostDigits(value, columns, form); digits > 1; --digits) {
    for (const auto& [format, precision] : {std::pair(std::chars_format::general, digits),
                                            std::pair(std::chars_format::scientific, digits - 1)}) {
      const std::string text = form(withDigits(value, format, precision));
      if (text.size() <= columns) return text;
    }
  }
  return form(withDigits(value, std::chars_format::scientific, 0));
}

}  // namespace

std::string numberInColumns(double value, std::size_t columns) {
  return inColumns(value, columns, &asItIs);
}

std::string nastranNumber(double value, std::size_t columns) {
  return inColumns(value, columns, &asNastran);
}

}  // namespace af2::geometry
