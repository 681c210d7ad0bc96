// A Boolean combination of leaves, and exact answers about it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dsl/shapes/leaf.h"

namespace af2::dsl::shapes {

enum class Operation { Leaf, Union, Intersection, Difference, Xor };

/// A regular closed set: leaves and the operations on them, in postfix order.
class Region {
 public:
  Region() = default;  ///< the empty set
  explicit Region(Leaf leaf);
  /// The result of the operation on `first` and `second`.
  Region(Region first, Operation operation, Region second);

  bool isEmpty() const { return nodes_.empty(); }
  std::span<const Leaf> leaves() const { return leaves_; }

  /// The place of a point: in the interior, on the boundary, or outside of the regular set.
  Place locate(Point2 point) const;

  /// A stretch of an edge: the sides that are inside the region (bits), and the same for each leaf.
  struct Stretch {
    const Crossing& from;
    const Crossing& to;
    std::uint8_t state;
    std::span<const std::uint8_t> leafStates;
  };

  /// Whether the edge meets the interior; with ZoneBoundary::Counts whether it meets the set.
  /// An edge counts as meeting the set even if it is outside except for one point that is not a
  /// corner or an end and in which boundaries of several leaves meet.
  bool meets(const Edge& edge, ZoneBoundary boundary) const;
  /// Whether the set contains the whole edge.
  bool covers(const Edge& edge) const;

  /// Calls `visit(Stretch)` for the stretches between events in order until it returns true;
  /// returns whether it did. `overrides` are given states for some leaves, which are then not
  /// followed.
  template <class Visit>
  bool alongEdge(const Edge& edge, std::span<const std::optional<std::uint8_t>> overrides,
                 Visit&& visit) const;

  /// Applies the operations to the states of the leaves, bit by bit, so that each side is separate.
  std::uint8_t combine(std::span<const std::uint8_t> leafStates) const;

 private:
  struct Node {
    Operation operation = Operation::Leaf;
    int leaf = 0;
  };

  Place combine(std::span<const Place> places) const;
  Place locateCloser(Point2 point, std::span<const Place> places) const;
  bool touches(const Edge& edge) const;

  /// An edge with respect to all leaves: their states just after its start, and events in order.
  struct Walk {
    std::vector<std::uint8_t> states;
    std::vector<Event> events;
  };
  Walk follow(const Edge& edge, std::span<const std::optional<std::uint8_t>> overrides) const;

  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
};

template <class Visit>
bool Region::alongEdge(const Edge& edge, std::span<const std::optional<std::uint8_t>> overrides,
                       Visit&& visit) const {
  auto [states, events] = follow(edge, overrides);
  Crossing from = Crossing::start(edge);
  const Crossing end = Crossing::end(edge);
  std::size_t next = 0;
  while (true) {
    while (next < events.size() && events[next].at.compare(from, edge) <= 0) {
      states[events[next].leaf] ^= events[next].flip;
      ++next;
    }
    if (from.compare(end, edge) >= 0) return false;
    const Crossing& to = next < events.size() ? events[next].at : end;
    if (visit(Stretch{from, to, combine(states), states})) return true;
    from = to;
  }
}

}  // namespace af2::dsl::shapes
