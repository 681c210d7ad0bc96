// A way to fill a face: triangulate its boundary, without vertices inside.
// Not installed.
#pragma once

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Whether a face is a strip, far narrower than its segments are long: vertices inside make its
/// elements only thinner. Curved faces that are to have quadrilaterals are none.
bool isNarrow(const FaceTask& task);
/// Whether the face is such a strip that is to have triangles. A front would try in vain to put
/// vertices there, at a cost of hundreds of candidates for each element.
bool needsNoVertices(const FillState& state);
/// Whether the face is such a strip that is to have quadrilaterals, or a curved face whose mesh
/// differs much from it in area.
bool mayNeedNoVertices(const FillState& state);
FaceAttempt fillFromBoundary(FillState& state);
/// Whether the mesh is better than the one with vertices inside, if there is one: judged by the
/// worst element in a narrow strip, by the area elsewhere. Where charts have not been tried yet, it
/// is good enough if it has the area of the face.
bool isBetterWithoutVertices(const FillState& state, const FaceAttempt& attempt);

/// Whether the area of the elements is about that of the face; true if the latter is unknown.
bool isNearArea(const FaceTask& task, const FaceAttempt& attempt);
/// The result of a run before its first step: the front is the whole boundary.
MeshingResult frontBeforeFirstStep(const FrontInput& boundary);

}  // namespace af2::geometry
