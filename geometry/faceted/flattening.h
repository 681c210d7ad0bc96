// Draws a patch of triangles in a plane, one-to-one.
// Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

/// Places of the vertices, such that all triangles lie counter-clockwise and none on another: the
/// longest boundary becomes a circle with about the area of the patch, and each vertex inside is
/// the mean of those around it, with weights that hold lengths and angles up as far as can be.
/// Source: [Floater03].
///
/// None if the triangles do not make a disc, perhaps with holes; or if rounding spoils the picture.
std::optional<std::vector<Point2>> flatten(
    const std::vector<Point3>& vertices,
    const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace af2::geometry
