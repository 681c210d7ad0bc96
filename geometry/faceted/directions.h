// Where the triangles of a surface look to.
// Not installed.
#pragma once

#include <functional>
#include <vector>

#include "geometry/faceted/flats.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Twins, by half-edge. Throws InputError if neighbours are turned against each other.
std::vector<HalfEdge> orientedTwins(const Facets& facets);

/// Normals that rounding and noise do not spoil.
///
/// sizeAt  wanted size of elements by position; none: noise stays as it is
FacetDirections directionsOf(const Facets& facets,
                             const std::function<double(const Point3&)>& sizeAt);

}  // namespace af2::geometry
