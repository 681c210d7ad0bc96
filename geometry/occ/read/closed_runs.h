// Loose faces in the order of a file: which of them make up a part.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

namespace af2::geometry {

/// Files write the faces of a part one after the other. Where the faces so far leave no edge open,
/// a part ends. Only so can parts be told from each other that touch: there, edges of both lie on
/// each other. Edges lie on each other if their lengths and their centres are the same.
///
/// shape      faces that share no edges
/// tolerance  of lengths and centres, in model units
///
/// Returns the faces in runs, as compounds, in their order; the last one holds all that is open, or
/// on which something open lies. A shape that is one part is one run.
std::vector<TopoDS_Shape> closedRuns(const TopoDS_Shape& shape, double tolerance);

}  // namespace af2::geometry
