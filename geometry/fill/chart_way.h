// A way to fill a face: through charts.
// Not installed.
#pragma once

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Through charts of one kind after the other, as chart_kind.cpp has them.
FaceAttempt fillThroughCharts(FillState& state);

/// Through charts of one kind: runs the front, and the optimiser if the charts are good for it, and
/// checks what came of it.
///
/// stallLimit  MeshingOptions::patience
FaceAttempt attemptWith(const FaceTask& task, const ChartTraits& chart, int stallLimit);

/// For a curved face with loops that are closed in the parameters: laid out in a plane, or with
/// affine charts. Elements may lean against the surface as far as they like. The vertices of the
/// mesh may have no normals.
FaceAttempt attemptIgnoringNormals(const FaceTask& task);

}  // namespace af2::geometry
