// Limits sizes where an edge passes near a sharp tip of a face.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Lowers the sizes along the edges of a face with a sharp tip if another edge passes so near the
/// tip that it would intersect the fan of triangles there, as where a cone is cut near its apex.
/// The sizes are such that the fan reaches halfway to that edge, and grow from there. Edges nearer
/// than a thousandth of the size are ignored.
///
/// ends, samples  by edge; [0] is edge 1
/// tips           as segmentsAtTips gave them
/// isGiven        by edge: its points are given
///
/// Returns whether there is such an edge: then the segments at the tips must be found again.
bool limitBesideTips(const ModelShape& model, const CadSizes& sizes, const std::vector<Ends>& ends,
                     const std::map<std::uint32_t, double>& tips, const std::vector<bool>& isGiven,
                     std::vector<EdgeSamples>& samples);

}  // namespace af2::geometry
