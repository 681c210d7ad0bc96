// Triangulates the polygons that files of surfaces may have as faces.
// Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

/// Divides a simple polygon, which may be concave and slightly non-planar, into triangles between
/// its corners, with its orientation. The result is a fan around the first corner if that is valid,
/// and also if no triangulation is valid because the polygon crosses itself.
///
/// corners  indices into vertices, at least three
std::vector<std::array<std::uint32_t, 3>> trianglesOfPolygon(
    std::span<const Point3> vertices, std::span<const std::uint32_t> corners);

}  // namespace af2::geometry
