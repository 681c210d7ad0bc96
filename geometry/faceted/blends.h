// Roundings that turn within far less than an element, as sharp edges.
// Not installed.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/faceted/facets.h"
#include "geometry/faceted/flats.h"

namespace af2::geometry {

/// What a mesh can show of roundings.
struct BlendLimits {
  double angle = 0;  ///< in radians: a rounding that turns by more than this becomes a sharp edge
  std::function<double(const Point3&)> sizeAt;  ///< wanted size of elements; none: all are seen
};

struct SharpBlends {
  std::vector<bool> isCrease;   ///< by half-edge: in the middle of a rounding, on both sides
  std::vector<Point3> normals;  ///< by triangle: in roundings those of the surface beside them
};

/// A rounding whose radius is below a quarter of the wanted size is divided between the surfaces
/// that it joins: each triangle is of the one from which the surface turns least on the way to it.
/// Where parts of surfaces meet that differ by more than the angle, are creases.
///
/// twins    by half-edge: the one across, or kNoHalfEdge at edges that are kept anyway
/// normals  by triangle, units; 0: there is nothing to tell it by
SharpBlends sharpenBlends(const Facets& facets, const std::vector<std::uint32_t>& twins,
                          std::vector<Point3> normals, const BlendLimits& limits);

}  // namespace af2::geometry
