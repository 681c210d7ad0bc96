// How two triangles in space lie to each other: apart, through each other, or one on the other.
#pragma once

#include <array>

#include "engine/base/point.h"

namespace af2::geometry {

using Corners = std::array<Point3, 3>;

/// Whether two triangles have points in common on more than their surface: no direction separates
/// them by more than -`depth`, in the unit of the coordinates. Corners in common, touching and what
/// rounding does to it stay below any depth that is larger than the error of the coordinates.
/// Triangles in one plane reach into each other if they overlap there.
/// Source: [Gottschalk96], separating axes.
bool reachIntoEachOther(const Corners& p, const Corners& q, double depth);

/// Whether the triangles a-b-c and a-b-d lie on each other: the angle between them at their common
/// edge is below `angle`, in radians.
bool areFolded(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double angle);

}  // namespace af2::geometry
