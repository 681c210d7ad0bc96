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
  std::size_t edges() const { return inner.size() + 1; }
};

/// A cut with fewer edges would consist only of its ends.
inline constexpr std::size_t kFewestCutEdges = 5;

/// A straight line in the parameter plane, to be divided into edges of the wanted sizes.
class CutLine {
 public:
  /// surface  must live as long as this
  CutLine(const SurfacePoint& from, const SurfacePoint& to, const SurfaceEvaluator& surface,
          const SizeField& size);

  /// The number of edges if all had exactly the wanted lengths.
  double wantedEdges() const { return sum_.back(); }
  /// The inner vertices, spaced evenly in length divided by wanted length.
  std::vector<SurfacePoint> divided(std::size_t edges) const;

 private:
  SurfacePoint pointAt(double t) const;

  SurfacePoint from_, to_;
  const SurfaceEvaluator& surface_;
  int samples_ = 0;
  std::vector<double> sum_{0};  ///< by sample: the wanted number of edges before it
};

/// Where a cut ends: at the corners nearest to the line, or straight across from its start. A line
/// may pass halfway between corners; straight cuts of a grid leave grids all the same.
enum class CutEnds { Nearest, Straight };

/// The cuts along the best line through a region whose loops run counter-clockwise around it in the
/// parameter plane; none if no line is suitable. Throws GeometryError where a line meets a point
/// without a normal.
std::vector<Cut> findCuts(const Loops& loops, const Plane& plane, const SurfaceEvaluator& surface,
                          const SizeField& size, CutEnds ends);

}  // namespace af2::region
