// Maps a patch of triangles to a plane, one-to-one.
// Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

/// Places of the vertices for which all triangles are counter-clockwise and none overlap: the
/// longest boundary becomes a circle with about the area of the patch, and each vertex inside is a
/// weighted mean of its neighbours, with weights that preserve lengths and angles as well as
/// possible. Source: [Floater03].
///
/// None if the triangles do not form a disc, perhaps with holes, or if rounding makes the result
/// invalid.
std::optional<std::vector<Point2>> flatten(
    const std::vector<Point3>& vertices,
    const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace af2::geometry
