// Where the straight segments of a boundary cross each other, though its curves may not.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "engine/mesh/front_input.h"

namespace af2::geometry {

/// A segment of a boundary: the corner of a loop at which it starts.
struct SegmentPlace {
  std::size_t loop = 0, corner = 0;
  bool operator==(const SegmentPlace&) const = default;
};

/// Pairs of segments that have a point in common other than a common vertex, in the plane that
/// `inPlane` draws the corners in. Exact for that drawing. No more than `limit` pairs.
std::vector<std::pair<SegmentPlace, SegmentPlace>> crossingsOf(
    const FrontInput& boundary, const std::function<Point2(const SurfacePoint&)>& inPlane,
    std::size_t limit);

}  // namespace af2::geometry
