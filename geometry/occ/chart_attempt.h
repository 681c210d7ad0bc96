// One way to fill a face: with charts of one kind.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/occ/face_attempt.h"

namespace af2::geometry {

/// Runs the front, and the optimiser if the charts are good for it, and checks what came of it.
///
/// mayStall  give up early where hardly anything gets on: there is another way to try
FaceAttempt attemptWith(const FaceTask& task, ChartKind kind, bool mayStall);

}  // namespace af2::geometry
