// The directions in which searches for better places look.
// Not installed.
#pragma once

#include <array>

#include "engine/base/point.h"

namespace af2 {

/// Every 45 degrees, counter-clockwise. Four directions are too few: at the bottom of a V-shaped
/// valley, as that of the worst of several elements, each of them may lead upwards.
inline constexpr double kDiagonal = 0.70710678118654757;
inline constexpr std::array<Point2, 8> kEightDirections{{{1, 0},
                                                         {kDiagonal, kDiagonal},
                                                         {0, 1},
                                                         {-kDiagonal, kDiagonal},
                                                         {-1, 0},
                                                         {-kDiagonal, -kDiagonal},
                                                         {0, -1},
                                                         {kDiagonal, -kDiagonal}}};

}  // namespace af2
