// Constants that several folders use, each with its unit and its reason.
// Not installed.
#pragma once

namespace af2 {

/// Area of the equilateral triangle with sides of length 1: sqrt(3) / 4. The expected number of
/// elements is an area divided by this.
inline constexpr double kUnitTriangle = 0.4330127018922193;

}  // namespace af2
