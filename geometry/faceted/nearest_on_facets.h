// The points of a surface of triangles that are nearest to given points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/export.h"
#include "geometry/faceted/facets.h"

namespace af2::geometry {

struct PointOnFacets {
  Point3 position;
  Point3 normal;  ///< of the triangle
  std::uint32_t triangle = 0;
};

/// For each of the points, the nearest point of the triangles; the first of equally near ones.
///
/// threads  0: as many as the machine has. The result does not depend on it.
///
/// Throws InputError if there are no triangles, or for a point without finite coordinates.
AF2_EXPORT std::vector<PointOnFacets> nearestPoints(const Facets& facets,
                                                    std::span<const Point3> points,
                                                    int threads = 0);

}  // namespace af2::geometry
