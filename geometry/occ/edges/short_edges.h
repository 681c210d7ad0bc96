// Finds short edges where a face fails: a surface may fold over next to them, or the detail that
// they bound may be smaller than any element.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/edges/edge_division.h"
#include "geometry/sizes/graded_size.h"

namespace af2::geometry {

/// The edges of a face that are short compared with the wanted size and within that size of one of
/// the places, if any are given: first only very short edges, then all up to a third of the size.
/// All choices differ.
std::vector<CollapsedEdges> shortEdgesNear(const ModelShape& model, int face,
                                           const DividedEdges& divided,
                                           const std::vector<SizeSource>& places, double wanted);

}  // namespace af2::geometry
