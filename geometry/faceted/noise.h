// What remains of the directions of triangles when noise is taken away.
// Not installed.
#pragma once

#include <functional>
#include <vector>

#include "geometry/faceted/flats.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Normals of triangles without noise: where the surface is rough on a scale that elements cannot
/// show, as on scans, each becomes a mean of those around it. Those that differ much count little,
/// so that edges stay. Elsewhere normals are as they were. Source: [Zheng11].
///
/// twins    by half-edge: the one across, or kNoHalfEdge where nothing is averaged across
/// normals  by triangle, units; 0: there is nothing to tell it by
/// sizeAt   wanted size of elements by position; none: nothing is too small
FacetDirections withoutNoise(const Facets& facets, const std::vector<HalfEdge>& twins,
                             std::vector<Point3> normals,
                             const std::function<double(const Point3&)>& sizeAt);

}  // namespace af2::geometry
