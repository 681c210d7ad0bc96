// Cuts triangles in two along a plane.
// Not installed.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// Cuts triangles along a plane that goes through no vertex: across the direction in which they
/// extend least, so that each half is seen from one side; those that extend about as far in all
/// directions, across the one in which they extend most.
///
/// cuts  gets the edges along the plane
void cutAcross(Facets& facets, const std::vector<std::uint32_t>& triangles,
               std::set<FacetEdge>& cuts);

}  // namespace af2::geometry
