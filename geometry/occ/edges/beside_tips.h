// Sizes where an edge passes near by a sharp tip of a face.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Lowers the sizes along the edges of faces with a sharp tip which another edge passes so near by
/// that it would run into the fan of triangles there, as where a cone is cut beside its apex: so
/// far that the fan reaches half the way to that edge, and sizes grow from there. What is nearer
/// than a thousandth of the size stays as it is.
///
/// ends, samples  by edge; [0] is edge 1
/// tips           as segmentsAtTips gave them
/// isGiven        by edge: its points are given
///
/// Returns whether there is such an edge: then the tips want other segments.
bool limitBesideTips(const ModelShape& model, const CadSizes& sizes, const std::vector<Ends>& ends,
                     const std::map<std::uint32_t, double>& tips, const std::vector<bool>& isGiven,
                     std::vector<EdgeSamples>& samples);

}  // namespace af2::geometry
