// How a face bends along its parameter lines.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <limits>

#include "geometry/occ/surfaces/general_surface.h"

namespace af2::geometry {

struct SurfaceBend {
  /// Whether some line turns by more than about a right angle.
  bool inU = false, inV = false;
  double extent = 0;  ///< distance of the points that are farthest from each other, roughly
  /// Of the shortest line that turns so; infinite if there is none.
  double breadth = std::numeric_limits<double>::infinity();
  /// The least radius of a crease across such lines; infinite if there are none.
  double creaseRadius = std::numeric_limits<double>::infinity();

  /// Takes in that of another part of the face.
  void add(const SurfaceBend& part);
};

/// box  the part of the parameters that the face takes up
SurfaceBend bendOf(const GeneralSurface& surface, const SplineSurface::Box& box);

}  // namespace af2::geometry
