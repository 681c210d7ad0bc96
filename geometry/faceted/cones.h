// Cuts a patch into pieces whose normals vary little.
// Not installed.
#pragma once

#include <set>
#include <vector>

#include "geometry/faceted/facets.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// The edges between pieces of a patch, each of which projects to a plane: no normal in a piece
/// deviates far from the mean of the piece. Pieces that would be narrower than elements are merged
/// with their neighbours.
///
/// angle  largest deviation, in radians; a third more where that makes borders shorter
/// size   wanted size of elements
std::set<FacetEdge> coneBorders(const PatchedFacets& patched, const Patch& patch, double angle,
                                double size);

}  // namespace af2::geometry
