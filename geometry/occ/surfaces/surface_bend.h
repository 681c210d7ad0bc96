// Measures how a face bends along its parameter lines.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <limits>

#include "geometry/occ/surfaces/general_surface.h"

namespace af2::geometry {

struct SurfaceBend {
  /// Whether some line turns by more than about a right angle.
  bool inU = false, inV = false;
  double extent = 0;  ///< approximate diameter
  /// Length of the shortest line that turns by so much; infinite if there is none.
  double breadth = std::numeric_limits<double>::infinity();
  /// Length of the longest such line, along the parameter in which they are shorter: around a pipe,
  /// but also around a nose with a small radius, or from edge to edge of a wing.
  double girth = std::numeric_limits<double>::infinity();
  /// The least radius of a crease across such lines; infinite if there are none.
  double creaseRadius = std::numeric_limits<double>::infinity();
  /// Whether such a line turns back and forth, so that the face is no tube.
  bool isWavy = false;

  /// Combines this with another part of the face.
  void add(const SurfaceBend& part);
};

/// box  the part of the parameters that the face occupies
SurfaceBend bendOf(const GeneralSurface& surface, const SplineSurface::Box& box);

}  // namespace af2::geometry
