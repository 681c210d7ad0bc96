// One way to fill a face: with charts of one kind.
// Not installed.
#pragma once

#include "geometry/fill/face_attempt.h"

namespace af2::geometry {

/// Runs the front, and the optimiser if the charts are good for it, and checks what came of it.
///
/// patience  of the front, as in MeshingOptions
FaceAttempt attemptWith(const FaceTask& task, ChartKind kind, int patience);

/// The last way, for a curved face with loops that are closed in the parameters: laid out in a
/// plane or with affine charts, but elements may lean against the surface as far as they like. The
/// vertices of the mesh may have no normals.
FaceAttempt attemptLeaning(const FaceTask& task);

}  // namespace af2::geometry
