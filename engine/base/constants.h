// Constants that several folders use, each with its unit and its reason.
// Not installed.
#pragma once

namespace af2 {

/// Area of the equilateral triangle with sides of length 1: sqrt(3) / 4. Divides areas where the
/// number of elements is estimated that a size asks for.
inline constexpr double kUnitTriangle = 0.4330127018922193;

/// Seen from another corner the distortion of a triangle may differ by this share: the last bits.
inline constexpr double kDistortionRounding = 1e-9;

}  // namespace af2
