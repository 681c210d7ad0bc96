#include "geometry/fill/crossed_boundary.h"

#include "geometry/check/boundary_crossings.h"
#include "geometry/fill/diagnose_face.h"

namespace af2::geometry {

bool mayHaveCrossedBoundary(const FillState& state) {
  return state.task.limits.failedBefore && state.task.surface.isPlane();
}

FaceAttempt findCrossedBoundary(FillState& state) {
  const FrontInput& boundary = state.task.boundary.input;
  const BoundaryPicture picture(state.task.surface, boundary);
  const bool isCrossed = !crossingsOf(boundary, picture, 1).empty();
  FaceAttempt attempt;
  attempt.fault.kind = isCrossed ? FillFaultKind::CrossedBoundary : FillFaultKind::NotFilled;
  return attempt;
}

}  // namespace af2::geometry
