// Finds ways to fill a ring of vertices with quadrilaterals that leave few irregular vertices.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/point.h"

namespace af2 {

/// A ring of vertices around a region. With one quadrilateral of the region at each corner and two
/// at each other vertex, all of them are regular.
struct Ring {
  std::vector<Point2> points;        ///< counter-clockwise
  std::vector<std::size_t> corners;  ///< places in `points`, in order
  /// Whether a vertex may become a corner, or cease to be one, and be irregular.
  std::vector<std::uint8_t> mayChange;
};

/// A way to fill a ring. Without a cut it becomes a grid if it has four corners and equal opposite
/// sides, and otherwise a star: one irregular vertex, from which a line of sides leads to each side
/// of the ring. With a cut, both parts become stars. Source: [Takayama14], [VermaSuresh15].
struct FillingPlan {
  /// A line of sides from one side of the ring to another one.
  struct Cut {
    std::size_t from, to;  ///< the sides, from < to; side i begins at corner i
    int fromAt, toAt;      ///< where on them, counted from their beginnings
    int length;
  };
  std::vector<std::size_t> corners;  ///< those of the ring with at most two changes
  std::optional<Cut> cut;
  int irregular = 0;   ///< number of irregular vertices, inside and at changed corners
  double badness = 0;  ///< how far the lines are from having the lengths of the ring's edges
};

/// The best plans: those with few irregular vertices first, then those with little badness.
///
/// mostIrregular  plans with more irregular vertices are left out
/// most           number of plans that are wanted
std::vector<FillingPlan> fillingPlans(const Ring& ring, int mostIrregular, std::size_t most);

}  // namespace af2
