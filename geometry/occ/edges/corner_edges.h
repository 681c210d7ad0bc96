// Edges that are short beside those before and after them, at corners where a face opens.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Limits the sizes along short edges to some times their length, so that sizes grow from there
/// along the edges beyond their ends: a long segment beside a short one makes a thin triangle.
/// Only where a face gets wider from the short edge on: where it is the end of a strip, or of a
/// wedge, triangles are thin all along that, and the shorter the more of them.
///
/// ends, samples  by edge; [0] is edge 1
void limitAtShortEdges(const ModelShape& model, const CadSizes& sizes,
                       const std::vector<Ends>& ends, std::vector<EdgeSamples>& samples);

}  // namespace af2::geometry
