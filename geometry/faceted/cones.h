// Cuts a patch into pieces that hardly turn.
// Not installed.
#pragma once

#include <set>
#include <vector>

#include "geometry/faceted/facets.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Edges between pieces of a patch that can be drawn in a plane each: no triangle of a piece turns
/// far from the middle of it. Pieces that would be narrower than elements become part of those
/// beside them.
///
/// angle  in radians: so far at most, or a third more where that makes borders shorter
/// size   wanted size of elements
std::set<FacetEdge> coneBorders(const PatchedFacets& patched, const Patch& patch, double angle,
                                double size);

}  // namespace af2::geometry
