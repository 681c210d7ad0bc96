// How much room there is around points that are to be vertices without lying on an edge.
// Not installed.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

/// For each of the points the distance to the nearest other one or chord, as a size that is wanted
/// there. Points that coincide with another are left out.
std::vector<SizeSource> roomAround(std::span<const Point3> points,
                                   std::span<const std::pair<Point3, Point3>> chords);

}  // namespace af2::geometry
