// A way to fill a face: triangulate its boundary, without vertices inside.
// Not installed.
#pragma once

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Whether the face is a plane strip far narrower than its segments are long, or a curved face
/// whose mesh differs much from it in area.
bool mayNeedNoVertices(const FillState& state);
FaceAttempt fillFromBoundary(FillState& state);
/// Whether the mesh is better than the one with vertices inside, if there is one: judged by the
/// worst element in a narrow strip, by the area elsewhere.
bool isBetterWithoutVertices(const FillState& state, const FaceAttempt& attempt);

/// Whether the area of the elements is about that of the face; true if the latter is unknown.
bool isNearArea(const FaceTask& task, const FaceAttempt& attempt);
/// The result of a run before its first step: the front is the whole boundary.
MeshingResult frontBeforeFirstStep(const FrontInput& boundary);

}  // namespace af2::geometry
