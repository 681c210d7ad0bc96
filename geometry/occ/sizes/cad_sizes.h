// Sizes on the faces and edges of CAD models: what was asked for, with its limits by curvature.
#pragma once

#include <set>

#include "geometry/sizes/sizes.h"

namespace af2::geometry {

/// By how much elements may turn with curved faces and edges, unless `Sizes::elementsPerTurn` says
/// it.
struct TurnLimits {
  /// Where an edge turns quickly it needs shorter segments: one segment turns by at most `edgeTurn`
  /// radians, unless it would be shorter than `edgeLeast` times the wanted length.
  double edgeTurn = 0.7854, edgeLeast = 0.1;
  /// Likewise on faces, and on edges next to them: an edge of an element turns by about `faceTurn`
  /// radians around the smaller radius of curvature. The default puts three rows of triangles
  /// across the rounding of a right angle: with two and a half, their vertices would not fit in.
  /// `bentFaceLeast` is for tubes, which turn by more than about a right angle: elements across the
  /// whole of them would cut off too much.
  double faceTurn = 0.6046, faceLeast = 0.35, bentFaceLeast = 0.1;
  /// What elements on curved faces and their edges aim at, as a share of the size that is wanted
  /// there. With `elementsPerTurn` it is 0.9: lengths scatter by a tenth, and hardly an edge is to
  /// be longer than wanted.
  double curvedShare = 1;
};

/// The sizes of a run, which begin as those asked for; spreadSizes makes those that edges are
/// divided and faces are filled by.
struct CadSizes : Sizes, TurnLimits {
  /// Faces that are rough rather than bent: there `bentFaceLeast` does not count. Sizes by
  /// curvature change faster on them than they could be sampled.
  std::set<int> roughFaces;
};

}  // namespace af2::geometry
