// What both VTK formats say of cells to which an array does not apply.
// Not installed.
#pragma once

#include <cstdint>
#include <limits>

namespace af2::geometry {

/// Types of cells.
inline constexpr std::uint8_t kVtkLine = 3, kVtkTriangle = 5, kVtkQuad = 9;
/// Those of second order.
inline constexpr std::uint8_t kVtkLine2 = 21, kVtkTriangle2 = 22, kVtkQuad2 = 23;

inline constexpr std::int32_t kFaceOfLine = 0, kRuleOfLine = -1;
/// A line is neither good nor bad: whoever takes the mean of all cells is to notice.
inline constexpr double kQualityOfLine = std::numeric_limits<double>::quiet_NaN();
/// `edge` and `boundary` of elements of the surface.
inline constexpr std::int32_t kOnNoEdge = 0;

}  // namespace af2::geometry
