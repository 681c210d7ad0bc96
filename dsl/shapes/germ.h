// The sectors of a set in an arbitrarily small disc around a point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dsl/shapes/leaf.h"

namespace af2::dsl::shapes {

/// The sectors into which the boundaries of some leaves cut the neighborhood of a point.
///
/// point   is on the boundary of each leaf whose place is On places  the place of the point
/// relative to each leaf Returns for each sector, counter-clockwise, the leaves that contain it (1
/// or 0 by leaf).
std::vector<std::vector<std::uint8_t>> sectorsAround(Point2 point, std::span<const Leaf> leaves,
                                                     std::span<const Place> places);

}  // namespace af2::dsl::shapes
