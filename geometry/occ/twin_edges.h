// Edges of a face that run along the same curve: the two sides of a seam that was not made one.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>
#include <vector>

#include "geometry/occ/edge_samples.h"
#include "geometry/occ/open_ends.h"

namespace af2::geometry {

/// For each edge an earlier one between the same points that it runs along, within the tolerances
/// of both, and that some face has as well. [0] is edge 1, as in `ends` and `samples`.
std::vector<std::optional<std::size_t>> twinsOf(const ModelShape& model,
                                                const std::vector<Ends>& ends,
                                                const std::vector<EdgeSamples>& samples);

}  // namespace af2::geometry
