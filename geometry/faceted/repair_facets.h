// Puts right what files of triangles often have wrong.
// Not installed.
#pragma once

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// In this order: edges shorter than a ten-millionth of the diagonal are collapsed; of triangles
/// with the same corners one is kept; edges with one triangle that lie on each other, to a
/// hundred-thousandth of the diagonal, are joined, also where one of them is several on the other
/// side; triangles that are turned against most of those around them are turned. Tells what was
/// done in facets.notes.
void repairFacets(Facets& facets);

}  // namespace af2::geometry
