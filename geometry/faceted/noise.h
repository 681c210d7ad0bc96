// Removes noise from the normals of triangles.
// Not installed.
#pragma once

#include <functional>
#include <vector>

#include "geometry/faceted/flats.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Normals of triangles without noise: where the surface is rough on a scale that elements cannot
/// resolve, as on scans, each normal becomes a mean of those around it. Normals that differ much
/// get little weight, so that edges stay. Elsewhere normals do not change. Source: [Zheng11].
///
/// twins    by half-edge: the opposite one, or kNoHalfEdge where nothing is averaged across
/// normals  by triangle, unit vectors; 0: unknown
/// sizeAt   wanted size of elements by position; none: nothing counts as noise
FacetDirections withoutNoise(const Facets& facets, const std::vector<HalfEdge>& twins,
                             std::vector<Point3> normals,
                             const std::function<double(const Point3&)>& sizeAt);

}  // namespace af2::geometry
