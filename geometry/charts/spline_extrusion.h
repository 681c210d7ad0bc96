// Recognises spline surfaces that are extrusions.
#pragma once

#include <optional>

#include "geometry/charts/spline_surface.h"

namespace af2::geometry {

struct Extrusion {
  Point3 direction;       ///< of unit length, towards greater parameters
  bool isAlongU = false;  ///< true if u runs along the direction; otherwise v does
};

/// Decided by the poles, with a tolerance of a millionth of their extent; nothing if the surface is
/// not an extrusion.
std::optional<Extrusion> extrusionOf(const SplineDefinition& definition);

}  // namespace af2::geometry
