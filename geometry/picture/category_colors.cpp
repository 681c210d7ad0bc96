#include "geometry/picture/category_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace af2::geometry {
namespace {

constexpr Rgb fromBytes(double red, double green, double blue) {
  return {red / 255, green / 255, blue / 255};
}

constexpr std::array kFirstColors{
    fromBytes(78, 121, 167),  fromBytes(242, 142, 43),  fromBytes(89, 161, 79),
    fromBytes(225, 87, 89),   fromBytes(118, 183, 178), fromBytes(237, 201, 72),
    fromBytes(176, 122, 161), fromBytes(255, 157, 167), fromBytes(156, 117, 95),
    fromBytes(140, 209, 125), fromBytes(160, 203, 232), fromBytes(212, 166, 200)};

}  // namespace

/// A list, and then steps of the golden angle around the hues.
Rgb categoryColor(std::size_t index) {
  if (index < kFirstColors.size()) return kFirstColors[index];
  const double hue = std::fmod(static_cast<double>(index) * 137.508, 360);
  const double light = 0.5 + 0.12 * static_cast<double>(index % 3);
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hue / 30, 12);
    return light -
           0.45 * std::min(light, 1 - light) * std::clamp(std::min(k - 3, 9 - k), -1.0, 1.0);
  };
  return {channel(0), channel(8), channel(4)};
}

}  // namespace af2::geometry
