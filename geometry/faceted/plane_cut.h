// Cuts triangles in two along a plane.
// Not installed.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Cuts triangles along a plane that goes through no vertex and is perpendicular to the direction
/// in which they extend least, so that each half faces one side. If they extend about equally in
/// all directions, the plane is perpendicular to the one in which they extend most. Triangles
/// beside them are divided where they share a side that the plane crosses.
///
/// directions  of the triangles; the pieces of a triangle get its direction
/// cuts        gets the edges along the plane
void cutAcross(Facets& facets, FacetDirections& directions,
               const std::vector<std::uint32_t>& triangles, std::set<FacetEdge>& cuts);

}  // namespace af2::geometry
