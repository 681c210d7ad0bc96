// Short edges where a face fails: a surface may turn over beside them, or what they bound may be
// smaller than any element.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/edges/edge_division.h"
#include "geometry/sizes/graded_size.h"

namespace af2::geometry {

/// The edges of a face that are short against the wanted size and lie within that size of one of
/// the places, if there are any: only very short ones first, then all up to a third of the size.
/// None twice alike.
std::vector<CollapsedEdges> shortEdgesNear(const ModelShape& model, int face,
                                           const DividedEdges& divided,
                                           const std::vector<SizeSource>& places, double wanted);

}  // namespace af2::geometry
