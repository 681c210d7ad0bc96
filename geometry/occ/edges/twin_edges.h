// Finds edges, or parts of them, along the same curve: the two sides of a seam that are not one
// edge, or of a face where it has no width, or edges of faces that are not sewn.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>
#include <vector>

#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// For each part, an earlier part between the same points along the same curve, if there is one.
/// Either some face has both, and their distance is within their tolerances or, if each belongs to
/// several faces, that of a sliver (kUnseenSliver); or each bounds only one face, on opposite
/// sides, and their distance is within a thousandth of the wanted size. Parts are in the order of
/// their edges.
std::vector<std::optional<std::size_t>> twinsOf(const ModelShape& model,
                                                const std::vector<EdgePart>& parts);

}  // namespace af2::geometry
