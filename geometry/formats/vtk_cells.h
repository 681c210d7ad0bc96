// Values that files have where an array does not apply: both VTK formats, and the page.
// Not installed.
#pragma once

#include <cstdint>
#include <limits>

#include "engine/mesh/mesh.h"

namespace af2::geometry {

/// Types of cells.
inline constexpr std::uint8_t kVtkLine = 3, kVtkTriangle = 5, kVtkQuad = 9;
/// Those of second order.
inline constexpr std::uint8_t kVtkLine2 = 21, kVtkTriangle2 = 22, kVtkQuad2 = 23;

/// `rule` of lines, and of elements that optimisation gave other corners.
inline constexpr std::int32_t kNoRule = -1;
inline std::int32_t ruleNumber(const ElementOrigin& origin) {
  return origin.isChanged ? kNoRule : std::int32_t{origin.rule};
}
/// `level` of lines, and of elements that no rule made or that were changed.
inline constexpr std::uint8_t kNoLevel = 0;
inline std::uint8_t levelNumber(const ElementOrigin& origin) {
  return origin.isChanged ? kNoLevel : origin.level;
}

inline constexpr std::int32_t kFaceOfLine = 0;
/// Lines have no quality. NaN makes sure that a mean over all cells does not silently include them.
inline constexpr double kQualityOfLine = std::numeric_limits<double>::quiet_NaN();
inline constexpr float kScoreOfLine = std::numeric_limits<float>::quiet_NaN();
/// `edge` and `boundary` of elements of the surface.
inline constexpr std::int32_t kOnNoEdge = 0;

}  // namespace af2::geometry
