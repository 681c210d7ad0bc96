// The normals of the triangles of a surface.
// Not installed.
#pragma once

#include <functional>
#include <vector>

#include "geometry/faceted/flats.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Normals from which errors by rounding and noise are removed.
///
/// sizeAt  wanted size of elements by position; none: noise is not removed
FacetDirections directionsOf(const Facets& facets,
                             const std::function<double(const Point3&)>& sizeAt);

}  // namespace af2::geometry
