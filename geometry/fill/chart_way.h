// A way to fill a face: through charts.
// Not installed.
#pragma once

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Tries one kind of charts after the other, in the order of chart_kind.cpp.
FaceAttempt fillThroughCharts(FillState& state);

/// Fills the face through charts of one kind: runs the front, and the optimiser if the charts are
/// suitable, and checks the result.
///
/// stallLimit  FrontOptions::stallSteps
FaceAttempt attemptWith(const FaceTask& task, const ChartTraits& chart, int stallLimit);

/// For a curved face whose loops are closed in the parameters: fills it in a plane layout or with
/// affine charts. Elements may tilt against the surface by any angle. The vertices of the mesh may
/// have no normals.
FaceAttempt attemptIgnoringNormals(const FaceTask& task);

}  // namespace af2::geometry
