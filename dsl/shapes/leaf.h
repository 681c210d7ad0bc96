// The basic sets of shapes (leaves), and the two queries that each of them answers.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "dsl/shapes/crossing.h"
#include "engine/base/point.h"
#include "engine/rule/free_zone.h"

namespace af2::dsl::shapes {

/// A closed polygon, inside by the even-odd rule; it may cross itself, as the chords of a path with
/// arcs may.
struct Polygon {
  std::vector<Point2> corners;
};

struct Leaf {
  std::variant<SmoothSet, Polygon> set;
  Box2 box;  ///< contains the set; may be infinite
};

Leaf makeLeaf(const SmoothSet& set);
Leaf makeLeaf(Polygon polygon);

enum class Place { Out, On, In };

Place locate(const Leaf& leaf, Point2 point);

/// The two sides of a directed edge, as bits. A state contains the sides on which the set is.
inline constexpr std::uint8_t kLeftSide = 1, kRightSide = 2, kBothSides = 3;

/// A point where an edge meets the boundary of a leaf.
struct Event {
  Crossing at;
  int leaf = 0;
  std::uint8_t flip = 0;  ///< the sides on which the state changes; 0: it only touches
};

/// Follows an edge of positive length. Returns the state of the leaf just after `from`, and appends
/// the events with 0 <= t <= 1. The state already includes changes at t = 0, so these are appended
/// as touches.
std::uint8_t trace(const Leaf& leaf, int leafIndex, const Edge& edge, std::vector<Event>& events);

}  // namespace af2::dsl::shapes
