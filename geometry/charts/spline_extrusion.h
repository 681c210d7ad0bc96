// Splines that are extrusions, whatever kind of surface they are stored as.
#pragma once

#include <optional>

#include "geometry/charts/spline_surface.h"

namespace af2::geometry {

struct Extrusion {
  Point3 direction;       ///< of unit length, towards greater parameters
  bool isAlongU = false;  ///< whether u runs along the direction; else v does
};

/// Told by the poles, to a millionth of their extent; nothing if the surface is no extrusion.
std::optional<Extrusion> extrusionOf(const SplineDefinition& definition);

}  // namespace af2::geometry
