// How two triangles in space are situated: apart, crossing, or overlapping.
#pragma once

#include <array>

#include "engine/base/point.h"

namespace af2::geometry {

using Corners = std::array<Point3, 3>;

/// Whether two triangles penetrate each other by more than `depth`, in the unit of the coordinates:
/// along every candidate axis their projections overlap by more than that. Common corners and
/// touching stay below any depth that is larger than the error of the coordinates. Triangles in one
/// plane penetrate each other if they overlap there. Source: [Gottschalk96], separating axes.
bool reachIntoEachOther(const Corners& p, const Corners& q, double depth);

/// Whether the triangles a-b-c and a-b-d overlap: the angle between them at their common edge is
/// below `angle`, in radians.
bool areFolded(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double angle);

}  // namespace af2::geometry
