#include "dsl/shapes/region.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>

#include "dsl/shapes/germ.h"

namespace af2::dsl::shapes {
namespace {

Place complement(Place place) {
  return place == Place::In ? Place::Out : place == Place::Out ? Place::In : Place::On;
}

/// The place of a point, given its places relative to the operands; On if these do not decide it.
Place apply(Operation operation, Place first, Place second) {
  switch (operation) {
    case Operation::Union:
      return std::max(first, second);
    case Operation::Intersection:
      return std::min(first, second);
    case Operation::Difference:
      return std::min(first, complement(second));
    case Operation::Xor:
      if (first == Place::On || second == Place::On) return Place::On;
      return first == second ? Place::Out : Place::In;
    case Operation::Leaf:
      break;
  }
  return first;
}

std::uint8_t apply(Operation operation, std::uint8_t first, std::uint8_t second) {
  switch (operation) {
    case Operation::Union:
      return first | second;
    case Operation::Intersection:
      return first & second;
    case Operation::Difference:
      return first & ~second;
    case Operation::Xor:
      return first ^ second;
    case Operation::Leaf:
      break;
  }
  return first;
}

template <class Value, class Nodes>
Value evaluate(const Nodes& nodes, std::span<const Value> leaves) {
  boost::container::small_vector<Value, 16> stack;
  for (const auto& node : nodes) {
    if (node.operation == Operation::Leaf) {
      stack.push_back(leaves[node.leaf]);
      continue;
    }
    const Value second = stack.back();
    stack.pop_back();
    stack.back() = apply(node.operation, stack.back(), second);
  }
  return stack.back();
}

}  // namespace

Region::Region(Leaf leaf) : nodes_{{Operation::Leaf, 0}} { leaves_.push_back(std::move(leaf)); }

Region::Region(Region first, Operation operation, Region second) {
  if (second.isEmpty()) {
    if (operation != Operation::Intersection) *this = std::move(first);
    return;
  }
  if (first.isEmpty()) {
    if (operation == Operation::Union || operation == Operation::Xor) *this = std::move(second);
    return;
  }
  *this = std::move(first);
  const int offset = static_cast<int>(leaves_.size());
  for (Leaf& leaf : second.leaves_) leaves_.push_back(std::move(leaf));
  for (Node node : second.nodes_) {
    node.leaf += offset;
    nodes_.push_back(node);
  }
  nodes_.push_back({operation, 0});
}

std::uint8_t Region::combine(std::span<const std::uint8_t> leafStates) const {
  return evaluate(nodes_, leafStates);
}

Place Region::combine(std::span<const Place> places) const { return evaluate(nodes_, places); }

Place Region::locate(Point2 point) const {
  if (isEmpty()) return Place::Out;
  boost::container::small_vector<Place, 16> places;
  for (const Leaf& leaf : leaves_) places.push_back(shapes::locate(leaf, point));
  const std::span<const Place> all(places.data(), places.size());
  const Place place = combine(all);
  return place == Place::On && leaves_.size() > 1 ? locateCloser(point, all) : place;
}

/// Boundaries of several leaves may form an inner seam, or cancel each other.
Place Region::locateCloser(Point2 point, std::span<const Place> places) const {
  bool anyIn = false, anyOut = false;
  for (const auto& sector : sectorsAround(point, leaves_, places)) {
    const bool isIn = combine(std::span<const std::uint8_t>(sector)) != 0;
    (isIn ? anyIn : anyOut) = true;
  }
  return !anyIn ? Place::Out : anyOut ? Place::On : Place::In;
}

bool Region::meets(const Edge& edge, ZoneBoundary boundary) const {
  if (isEmpty()) return false;
  if (edge.from == edge.to || boundary == ZoneBoundary::Counts) {
    const Place needed = boundary == ZoneBoundary::Counts ? Place::On : Place::In;
    if (locate(edge.from) >= needed || locate(edge.to) >= needed) return true;
    if (edge.from == edge.to) return false;
  }
  if (boundary == ZoneBoundary::Ignored)
    return alongEdge(edge, {}, [](const Stretch& s) { return s.state == kBothSides; });
  return alongEdge(edge, {}, [](const Stretch& s) { return s.state != 0; }) || touches(edge);
}

bool Region::covers(const Edge& edge) const {
  if (isEmpty()) return false;
  if (edge.from == edge.to) return locate(edge.from) != Place::Out;
  return !alongEdge(edge, {}, [](const Stretch& s) { return s.state == 0; });
}

Region::Walk Region::follow(const Edge& edge,
                            std::span<const std::optional<std::uint8_t>> overrides) const {
  Walk walk;
  walk.states.resize(leaves_.size());
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    const bool fixed = i < overrides.size() && overrides[i];
    walk.states[i] =
        fixed ? *overrides[i] : trace(leaves_[i], static_cast<int>(i), edge, walk.events);
  }
  std::sort(walk.events.begin(), walk.events.end(),
            [&](const Event& a, const Event& b) { return a.at.compare(b.at, edge) < 0; });
  return walk;
}

/// For an edge that is outside except for single points: whether such a point is between its ends.
bool Region::touches(const Edge& edge) const {
  auto [states, events] = follow(edge, {});
  for (std::size_t first = 0, last = 0; first < events.size(); first = last) {
    std::vector<Place> places;
    for (const std::uint8_t state : states)
      places.push_back(state == kBothSides ? Place::In : state == 0 ? Place::Out : Place::On);

    std::optional<Point2> corner;
    for (; last < events.size() && events[last].at.compare(events[first].at, edge) == 0; ++last) {
      places[events[last].leaf] = Place::On;
      states[events[last].leaf] ^= events[last].flip;
      if (!corner) corner = events[last].at.point();
    }
    if (corner ? locate(*corner) != Place::Out : combine(places) != Place::Out) return true;
  }
  return false;
}

}  // namespace af2::dsl::shapes
