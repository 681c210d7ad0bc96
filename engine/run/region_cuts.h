// Where to cut a region in two: straight lines in the parameter plane, from boundary to boundary.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/run/region_split.h"

namespace af2::region {

using Loop = std::vector<BoundaryCorner>;
using Loops = std::vector<Loop>;

/// The parameter plane stretched so that lengths in it are about lengths on the surface.
struct Plane {
  double scaleU = 1, scaleV = 1;
  Point2 at(const BoundaryCorner& c) const { return {scaleU * c.point.u, scaleV * c.point.v}; }
};

struct Box {
  Point2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  void include(Point2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

template <class Visit>
void forEachEdge(const Loops& loops, Visit&& visit) {
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t i = 0; i < loops[l].size(); ++i)
      visit(loops[l][i], loops[l][(i + 1) % loops[l].size()]);
}

/// One corner of one loop.
struct Spot {
  std::size_t loop = 0, corner = 0;
  bool operator==(const Spot&) const = default;
};

/// A planned cut: a straight line in the parameter plane between two corners, and its inner
/// vertices.
struct Cut {
  Spot from, to;
  std::vector<SurfacePoint> inner;
};

/// The cuts along the best line through a region whose loops run counter-clockwise around it in the
/// parameter plane; none if no line is suitable. Throws GeometryError where a line meets a point
/// without a normal.
std::vector<Cut> findCuts(const Loops& loops, const Plane& plane, const SurfaceEvaluator& surface,
                          const SizeField& size);

}  // namespace af2::region
