// Repairs common faults of files of triangles.
// Not installed.
#pragma once

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// In this order: edges shorter than a ten-millionth of the diagonal are collapsed; of triangles
/// with the same corners one is kept; edges with one triangle that coincide, to a
/// hundred-thousandth of the diagonal, are joined, also where one edge matches several on the other
/// side; triangles that are oriented against most of their neighbours are reversed, unless the
/// surface has only one side. Reports the repairs in facets.notes.
void repairFacets(Facets& facets);

}  // namespace af2::geometry
