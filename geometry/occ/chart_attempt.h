// One way to fill a face: with charts of one kind.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/occ/face_attempt.h"

namespace af2::geometry {

/// Runs the front, and the optimiser if the charts are good for it, and checks what came of it.
///
/// patience  of the front, as in MeshingOptions
FaceAttempt attemptWith(const FaceTask& task, ChartKind kind, int patience);

}  // namespace af2::geometry
