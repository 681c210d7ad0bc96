// Separates parts of an assembly that touch.
// Not installed.
#pragma once

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// Closed parts that share vertices get vertices of their own, so that each can be meshed by
/// itself. Around an edge with more than two triangles, two triangles belong to the same part if
/// there is material between them. Parts with a common wall, all triangles of which exist twice,
/// stay together, because the wall bounds both. The notes report what was done.
void partTouching(Facets& facets);

}  // namespace af2::geometry
