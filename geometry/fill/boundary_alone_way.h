// A way to fill a face: triangulated from its boundary alone, without vertices inside.
// Not installed.
#pragma once

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// A strip of a plane that is far narrower than its segments are long, or a curved face whose mesh
/// has an area that is far from the face's.
bool mayNeedNoVertices(const FillState& state);
FaceAttempt fillFromBoundary(FillState& state);
/// Whether the mesh is better than that with vertices inside, if there is one: by its worst
/// element in a narrow strip, by its area elsewhere.
bool isBetterWithoutVertices(const FillState& state, const FaceAttempt& attempt);

/// Whether the area of the elements is about that of the face, so far as that is known.
bool isNearArea(const FaceTask& task, const FaceAttempt& attempt);
/// The front is all of the boundary, as it is before the first step.
MeshingResult frontBeforeFirstStep(const FrontInput& boundary);

}  // namespace af2::geometry
