// Parts of an assembly that touch, taken apart.
// Not installed.
#pragma once

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// Closed parts that have vertices in common get vertices of their own, so that each can be meshed
/// by itself. Around an edge with more than two triangles those belong together that have material
/// between them. Parts with a wall in common, all triangles of which are there twice, stay
/// together: the wall bounds both. What was done is told in the notes.
void partTouching(Facets& facets);

}  // namespace af2::geometry
