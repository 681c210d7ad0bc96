// The sets from which every shape is put together, and the two questions asked of each of them.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "dsl/shapes/crossing.h"
#include "engine/base/point.h"
#include "engine/rule/free_zone.h"

namespace af2::dsl::shapes {

/// A closed polygon, inside by the even-odd rule; it may cross itself (the chords of a path with
/// arcs may).
struct Polygon {
  std::vector<Point2> corners;
};

struct Leaf {
  std::variant<SmoothSet, Polygon> set;
  Box2 box;  ///< holds the set; may be infinite
};

Leaf makeLeaf(const SmoothSet& set);
Leaf makeLeaf(Polygon polygon);

enum class Place { Out, On, In };

Place locate(const Leaf& leaf, Point2 point);

/// The two sides of a directed edge, as bits. A state says on which of them a set lies.
inline constexpr std::uint8_t kLeftSide = 1, kRightSide = 2, kBothSides = 3;

/// Where an edge meets the boundary of a leaf.
struct Event {
  Crossing at;
  int leaf = 0;
  std::uint8_t flip = 0;  ///< the sides on which the state changes; 0: touched only
};

/// Follows an edge whose ends are apart: returns the state of the leaf just after `from`, appends
/// the events with 0 <= t <= 1. Flips at t = 0 are in the state already and come as touches.
std::uint8_t trace(const Leaf& leaf, int leafIndex, const Edge& edge, std::vector<Event>& events);

}  // namespace af2::dsl::shapes
