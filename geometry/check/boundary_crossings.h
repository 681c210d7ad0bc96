// Finds where the straight segments of a boundary cross, even where its curves do not.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "engine/mesh/front_input.h"

namespace af2::geometry {

/// A segment of a boundary, given by the corner of a loop at which it starts.
struct SegmentPlace {
  std::size_t loop = 0, corner = 0;
  bool operator==(const SegmentPlace&) const = default;
};

/// Pairs of segments that share a point other than a common vertex, in the plane to which `inPlane`
/// maps the corners. Exact in that plane. At most `limit` pairs.
std::vector<std::pair<SegmentPlace, SegmentPlace>> crossingsOf(
    const FrontInput& boundary, const std::function<Point2(const SurfacePoint&)>& inPlane,
    std::size_t limit);

}  // namespace af2::geometry
