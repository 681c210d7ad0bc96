// Replaces roundings that are far smaller than an element by sharp edges.
// Not installed.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/faceted/facets.h"
#include "geometry/faceted/flats.h"

namespace af2::geometry {

/// The roundings that a mesh can resolve.
struct BlendLimits {
  double angle =
      0;  ///< in radians: a small rounding that turns by more than this becomes a sharp edge
  std::function<double(const Point3&)> sizeAt;  ///< wanted size of elements; none: all are resolved
};

struct SharpBlends {
  std::vector<bool> isCrease;   ///< by half-edge: in the middle of a rounding, on both sides
  std::vector<Point3> normals;  ///< by triangle: in a rounding, those of the surface next to it
};

/// A rounding whose radius is below a quarter of the wanted size is divided between the surfaces
/// that it joins: each triangle goes to the surface from which the normal turns least on the way to
/// the triangle. Creases are where parts of surfaces meet whose normals differ by more than the
/// angle.
///
/// twins    by half-edge: the opposite one, or kNoHalfEdge at edges that are kept anyway
/// normals  by triangle, unit vectors; 0: unknown
SharpBlends sharpenBlends(const Facets& facets, const std::vector<std::uint32_t>& twins,
                          std::vector<Point3> normals, const BlendLimits& limits);

}  // namespace af2::geometry
