// The directions in which a set of triangles extends most and least.
// Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// Three unit vectors at right angles to each other: the principal axes of the area, in no
/// particular order.
std::array<Point3, 3> mainDirections(const Facets& facets,
                                     const std::vector<std::uint32_t>& triangles);

}  // namespace af2::geometry
