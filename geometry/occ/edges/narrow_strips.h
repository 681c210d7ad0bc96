// Limits sizes along edges next to which a face is narrow.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <set>
#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/open_ends.h"

namespace af2::geometry {

/// Lowers the sizes along edges next to which the face is narrower than a certain share of the
/// size, so that elements across the strip have good angles, and the segments of its two sides have
/// equal lengths and face each other. Wedges are not changed, because no division opens their
/// angle.
///
/// ends     by edge; [0] is edge 1
/// samples  by edge
/// without  ids of faces that change nothing
void limitInStrips(const ModelShape& model, const CadSizes& sizes, const std::vector<Ends>& ends,
                   int threads, std::vector<EdgeSamples>& samples,
                   const std::set<int>& without = {});

}  // namespace af2::geometry
