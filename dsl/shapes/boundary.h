// The boundary of a region as pieces of lines and circles, rounded: for drawing and for `grow`.
#pragma once

#include <optional>
#include <vector>

#include "dsl/shapes/region.h"

namespace af2::dsl::shapes {

/// A piece of boundary with the region on its left.
struct Piece {
  struct Arc {
    Disc circle;
    double start = 0, sweep = 0;  ///< angles in radians; sweep < 0: clockwise
  };
  Point2 from, to;  ///< equal for a whole circle
  std::optional<Arc> arc;
};

/// All pieces of the boundary of a bounded region, in no particular order.
///
/// box  finite, contains the region
std::vector<Piece> boundaryOf(const Region& region, const Box2& box);

/// Joins pieces to closed loops. Arcs are sampled so that no chord is farther than `sag` from its
/// arc.
std::vector<std::vector<Point2>> loopsOf(std::vector<Piece> pieces, double sag);

}  // namespace af2::dsl::shapes
