// Finds the room around isolated points, which become vertices without being on an edge.
// Not installed.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

/// For each of the points, the distance to the nearest other point or chord, as a wanted size
/// there. Points that coincide with another one are left out.
std::vector<SizeSource> roomAround(std::span<const Point3> points,
                                   std::span<const std::pair<Point3, Point3>> chords);

}  // namespace af2::geometry
