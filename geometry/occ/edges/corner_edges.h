// Limits sizes next to short edges at corners where a face gets wider.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Limits the sizes along short edges to a multiple of their length, so that sizes grow from there
/// along the adjacent edges: a long segment next to a short one makes a thin triangle. This is done
/// only where a face gets wider away from the short edge. If the short edge is the end of a strip
/// or of a wedge, triangles are thin along all of it, and shorter segments would only make more of
/// them.
///
/// ends, samples  by edge; [0] is edge 1
void limitAtShortEdges(const ModelShape& model, const CadSizes& sizes,
                       const std::vector<Ends>& ends, std::vector<EdgeSamples>& samples);

}  // namespace af2::geometry
