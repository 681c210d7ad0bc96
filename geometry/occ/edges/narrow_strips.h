// Sizes along edges where a face is narrow beside them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/open_ends.h"

namespace af2::geometry {

/// Lowers the sizes along edges where the face beside them is narrower than a part of the size, so
/// that elements across the strip have fair angles, and the segments of its two sides, being alike,
/// face each other. Wedges stay as they are: no division opens them.
///
/// ends     by edge; [0] is edge 1
/// samples  by edge
void limitInStrips(const ModelShape& model, const CadSizes& sizes, const std::vector<Ends>& ends,
                   int threads, std::vector<EdgeSamples>& samples);

}  // namespace af2::geometry
