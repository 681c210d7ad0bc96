// Triangles of the polygons that OBJ files may have as faces.
// Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

/// Divides a simple polygon, which may be concave and need not be quite plane, into triangles with
/// its corners, turned as it is. All around its first corner if they fit there; also if no division
/// fits, since the polygon crosses itself.
///
/// corners  indices into vertices, at least three
std::vector<std::array<std::uint32_t, 3>> trianglesOfPolygon(
    std::span<const Point3> vertices, std::span<const std::uint32_t> corners);

}  // namespace af2::geometry
