// Groups the loose faces of a file into parts.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

namespace af2::geometry {

/// Files contain the faces of a part consecutively. A part ends where the faces so far leave no
/// edge open. This is the only way to separate parts that touch, because there edges of both
/// coincide. Edges coincide if their lengths and their centres are the same.
///
/// shape      faces that share no edges
/// tolerance  of lengths and centres, in model units
///
/// Returns the runs of faces, as compounds, in their order; the last one contains all faces that
/// are open or touch an open one. A shape that is one part is one run.
std::vector<TopoDS_Shape> closedRuns(const TopoDS_Shape& shape, double tolerance);

}  // namespace af2::geometry
