// The colours of elements by quality, the same as in the page for browsers.
// Not installed.
#pragma once

#include <array>
#include <string>

namespace af2::geometry {

/// Red, green and blue, 0 to 1.
struct Rgb {
  double red = 0, green = 0, blue = 0;
};

inline Rgb operator*(double s, const Rgb& c) { return {s * c.red, s * c.green, s * c.blue}; }
inline Rgb operator+(const Rgb& a, const Rgb& b) {
  return {a.red + b.red, a.green + b.green, a.blue + b.blue};
}
inline Rgb mixed(const Rgb& a, const Rgb& b, double partOfB) {
  return (1 - partOfB) * a + partOfB * b;
}

/// The colours of the qualities 0, 1/4, 1/2, 3/4 and 1.
inline constexpr std::array kQualityColors{
    Rgb{165 / 255.0, 0, 38 / 255.0}, Rgb{244 / 255.0, 109 / 255.0, 67 / 255.0},
    Rgb{254 / 255.0, 224 / 255.0, 144 / 255.0}, Rgb{160 / 255.0, 205 / 255.0, 226 / 255.0},
    Rgb{78 / 255.0, 131 / 255.0, 189 / 255.0}};
inline constexpr Rgb kOutlineColor{0.08, 0.125, 0.17}, kStuckColor{0.9, 0.05, 0.05};

/// The colour of a quality; those below 0 have the colour of 0.
Rgb qualityColor(double quality);

/// As style sheets have it: "#rrggbb".
std::string hexOf(const Rgb& color);

}  // namespace af2::geometry
