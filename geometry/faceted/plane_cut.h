// Cuts triangles in two along a plane.
// Not installed.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// Cuts triangles along a plane across their longest direction that goes through no vertex.
///
/// cuts  gets the edges along the plane
void cutAcross(Facets& facets, const std::vector<std::uint32_t>& triangles,
               std::set<FacetEdge>& cuts);

}  // namespace af2::geometry
