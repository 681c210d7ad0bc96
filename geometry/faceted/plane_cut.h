// Cuts triangles in two along a plane.
// Not installed.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Cuts triangles along a plane that goes through no vertex: across the direction in which they
/// extend least, so that each half is seen from one side; those that extend about as far in all
/// directions, across the one in which they extend most.
///
/// directions  of the triangles; those of what a triangle is cut into are its own
/// cuts        gets the edges along the plane
void cutAcross(Facets& facets, FacetDirections& directions,
               const std::vector<std::uint32_t>& triangles, std::set<FacetEdge>& cuts);

}  // namespace af2::geometry
