// Sizes on the faces and edges of CAD models: the requested sizes and their limits by curvature.
#pragma once

#include <set>

#include "geometry/sizes/sizes.h"

namespace af2::geometry {

/// The angles by which elements may turn on curved faces and edges, unless `Sizes::elementsPerTurn`
/// is given.
struct TurnLimits {
  /// An edge that turns quickly gets shorter segments: one segment turns by at most `edgeTurn`
  /// radians, unless it would be shorter than `edgeLeast` times the wanted length.
  double edgeTurn = 0.7854, edgeLeast = 0.1;
  /// Likewise on faces, and on edges next to them: an edge of an element turns by about `faceTurn`
  /// radians around the smaller radius of curvature. The default puts three rows of triangles
  /// across the rounding of a right angle: with two and a half rows, their vertices would not fit.
  /// `bentFaceLeast` is for tubes, which turn by more than about a right angle: elements as large
  /// as the tube would cut off too much.
  double faceTurn = 0.6046, faceLeast = 0.35, bentFaceLeast = 0.1;
  /// The size at which elements on curved faces and their edges aim, as a share of the size wanted
  /// there. With `elementsPerTurn` it is 0.9: lengths scatter by a tenth, and almost no edge should
  /// be longer than wanted.
  double curvedShare = 1;
};

/// The sizes of a run. They start as the requested sizes; spreadSizes makes the sizes that are used
/// to divide edges and fill faces.
struct CadSizes : Sizes, TurnLimits {
  /// Faces that are rough rather than bent, on which `bentFaceLeast` is not used. Sizes by
  /// curvature vary faster on them than they could be sampled.
  std::set<int> roughFaces;
};

}  // namespace af2::geometry
