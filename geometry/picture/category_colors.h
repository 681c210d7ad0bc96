// Colours that differ for neighbouring numbers, the same as in the page for browsers.
// Not installed.
#pragma once

#include <cstddef>

#include "geometry/picture/quality_colors.h"

namespace af2::geometry {

/// The colour of the category with this index, from 0.
Rgb categoryColor(std::size_t index);

/// For what belongs to no category.
inline constexpr Rgb kColorOfNone{150 / 255.0, 158 / 255.0, 166 / 255.0};

}  // namespace af2::geometry
