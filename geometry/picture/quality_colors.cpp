#include "geometry/picture/quality_colors.h"

#include <algorithm>
#include <cmath>

namespace af2::geometry {

Rgb qualityColor(double quality) {
  constexpr std::size_t last = kQualityColors.size() - 1;
  const double at = std::clamp(quality, 0.0, 1.0) * static_cast<double>(last);
  const std::size_t below = std::min(static_cast<std::size_t>(at), last - 1);
  return mixed(kQualityColors[below], kQualityColors[below + 1], at - static_cast<double>(below));
}

std::string hexOf(const Rgb& color) {
  constexpr char digits[] = "0123456789abcdef";
  std::string hex = "#";
  for (const double part : {color.red, color.green, color.blue}) {
    const int byte = static_cast<int>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
    hex += {digits[byte / 16], digits[byte % 16]};
  }
  return hex;
}

}  // namespace af2::geometry
