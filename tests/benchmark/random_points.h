// Points to try predicates and zones on; the same in every run.
#pragma once

#include <array>
#include <cstddef>
#include <random>

#include "engine/base/point.h"

namespace af2::benchmark {

inline constexpr std::size_t kPoints = 1024;
using Points = std::array<Point2, kPoints>;

/// In the square of side 4 around the origin.
inline Points scatteredPoints() {
  std::mt19937_64 random(1);
  const auto coordinate = [&] { return 4.0 * static_cast<double>(random() >> 11) * 0x1p-53 - 2.0; };
  Points points;
  for (Point2& point : points) point = {coordinate(), coordinate()};
  return points;
}

/// On a line, up to rounding: what fronts along straight boundaries are made of.
inline Points nearlyCollinearPoints() {
  Points points;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double t = 0.1 * static_cast<double>(i * 7 % kPoints);
    points[i] = {t / 3, 0.7 * (t / 3) + 0.1};
  }
  return points;
}

}  // namespace af2::benchmark
