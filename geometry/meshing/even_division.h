// Divides the edges of a model so that the loops around its faces are even.
// Not installed.
#pragma once

#include <stop_token>

#include "geometry/meshing/face_source.h"

namespace af2::geometry {

/// Divides all edges. Where possible, the loops around every face, requested or not, get even
/// numbers of segments; numbers of segments change by at most one for this.
DividedEdges divideWithEvenLoops(const FaceSource& source, const PositionSize& sizes,
                                 const CollapsedEdges& asPoints, int threads,
                                 const std::stop_token& stop);

}  // namespace af2::geometry
