// Edges, or parts of them, that run along the same curve: the two sides of a seam that was not made
// one, or of a face where it has no width, or edges of faces that were not sewn.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>
#include <vector>

#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// For each part an earlier one between the same points that it runs along: some face has both, and
/// they are as near as their tolerances say; or each bounds one face only, from one side and the
/// other, and they are within a thousandth of the wanted size. Parts are in the order of their
/// edges.
std::vector<std::optional<std::size_t>> twinsOf(const ModelShape& model,
                                                const std::vector<EdgePart>& parts);

}  // namespace af2::geometry
