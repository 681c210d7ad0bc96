#include "dsl/shapes/leaf.h"

#include <algorithm>
#include <cmath>

#include "engine/base/predicates.h"

namespace af2::dsl::shapes {
namespace {

constexpr Box2 kEverywhere{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};

Box2 boxOf(const Polygon& polygon) {
  Box2 box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Point2 p : polygon.corners) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

Box2 boxOf(const SmoothSet& set) {
  const auto* disc = std::get_if<Disc>(&set);
  if (!disc) return kEverywhere;
  const Point2 c = disc->centre;
  const double r = disc->radius;
  return {{std::nextafter(c.x - r, -kInfinity), std::nextafter(c.y - r, -kInfinity)},
          {std::nextafter(c.x + r, kInfinity), std::nextafter(c.y + r, kInfinity)}};
}

bool isOutside(const Box2& box, Point2 p) {
  return p.x < box.low.x || p.x > box.high.x || p.y < box.low.y || p.y > box.high.y;
}

bool isOutside(const Box2& box, const Edge& e) {
  return std::max(e.from.x, e.to.x) < box.low.x || std::min(e.from.x, e.to.x) > box.high.x ||
         std::max(e.from.y, e.to.y) < box.low.y || std::min(e.from.y, e.to.y) > box.high.y;
}

/// Even-odd rule: counts the sides that the ray from `point` to the right crosses.
Place locate(const Polygon& polygon, Point2 point) {
  bool inside = false;
  const auto& corners = polygon.corners;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Point2 p = corners[j], q = corners[i];
    const bool spans = (p.y > point.y) != (q.y > point.y);
    if (!spans && !liesBetween(point, p, q)) continue;
    const Turn turn = orientation(p, q, point);
    if (turn == Turn::Straight && liesBetween(point, p, q)) return Place::On;
    if (spans && (turn == Turn::Left) == (q.y > p.y)) inside = !inside;
  }
  return inside ? Place::In : Place::Out;
}

/// Adds an event of a leaf, or includes it in the state at the start of the edge.
class Tracer {
 public:
  Tracer(const Edge& edge, int leaf, std::vector<Event>& events)
      : edge_(edge),
        start_(Crossing::start(edge)),
        end_(Crossing::end(edge)),
        leaf_(leaf),
        events_(events) {}

  void add(const Crossing& at, std::uint8_t flip) {
    const int beyondStart = at.compare(start_, edge_);
    if (beyondStart <= 0) state ^= flip;
    if (beyondStart < 0 || at.compare(end_, edge_) > 0) return;
    events_.push_back({at, leaf_, beyondStart == 0 ? std::uint8_t{0} : flip});
  }

  std::uint8_t state = 0;  ///< before all events: far behind the start, on the line of the edge

 private:
  const Edge& edge_;
  Crossing start_, end_;
  int leaf_;
  std::vector<Event>& events_;
};

/// Each side of the edge is followed separately, as if the edge were moved by an infinitesimal
/// distance to that side. Then no corner is on the line, and there are no special cases.
void trace(const Polygon& polygon, const Edge& edge, Tracer& tracer) {
  const auto& corners = polygon.corners;
  Turn before = orientation(edge.from, edge.to, corners.back());
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Turn after = orientation(edge.from, edge.to, corners[i]);
    const Turn turns[] = {before, after};
    before = after;
    std::uint8_t flip = 0;
    if ((turns[0] == Turn::Left) != (turns[1] == Turn::Left)) flip |= kLeftSide;
    if ((turns[0] == Turn::Right) != (turns[1] == Turn::Right)) flip |= kRightSide;
    if (flip == 0) continue;
    if (turns[0] == Turn::Straight) {
      tracer.add(Crossing::atPoint(edge, corners[j]), flip);
    } else if (turns[1] == Turn::Straight) {
      tracer.add(Crossing::atPoint(edge, corners[i]), flip);
    } else {
      tracer.add(Crossing::withLine(edge, {corners[j], corners[j], corners[i]}), flip);
    }
  }
}

/// Along a line parallel to the edge, or on it.
std::uint8_t stateBeside(const HalfPlane& plane, const Edge& edge, int side) {
  if (side != 0) return side > 0 ? kBothSides : 0;
  const int heading = signOf([&]<class N>() {
    return dot(difference<N>(plane.tail, plane.tip), difference<N>(edge.from, edge.to));
  });
  return heading > 0 ? kLeftSide : kRightSide;
}

void trace(const HalfPlane& plane, const Edge& edge, Tracer& tracer) {
  const SmoothSet set = plane;
  const int slope = signOf([&]<class N>() { return along(curveOf<N>(plane), edge).b; });
  if (slope == 0) {
    tracer.state = stateBeside(plane, edge, sideOf(set, edge.from));
    return;
  }
  tracer.state = slope > 0 ? 0 : kBothSides;
  if (sideOf(set, edge.from) * sideOf(set, edge.to) > 0) {
    tracer.state = sideOf(set, edge.from) > 0 ? kBothSides : 0;
    return;
  }
  tracer.add(Crossing::withLine(edge, plane), kBothSides);
}

void trace(const SmoothSet& disc, const Edge& edge, Tracer& tracer) {
  const auto crossings = Crossing::withCircle(edge, disc);
  if (!crossings) return;
  tracer.add(crossings->first, kBothSides);
  tracer.add(crossings->second, kBothSides);
}

}  // namespace

Leaf makeLeaf(const SmoothSet& set) { return {set, boxOf(set)}; }

Leaf makeLeaf(Polygon polygon) {
  const Box2 box = boxOf(polygon);
  return {std::move(polygon), box};
}

Place locate(const Leaf& leaf, Point2 point) {
  if (isOutside(leaf.box, point)) return Place::Out;
  if (const auto* polygon = std::get_if<Polygon>(&leaf.set)) return locate(*polygon, point);
  const int side = sideOf(std::get<SmoothSet>(leaf.set), point);
  return side > 0 ? Place::In : side < 0 ? Place::Out : Place::On;
}

std::uint8_t trace(const Leaf& leaf, int leafIndex, const Edge& edge, std::vector<Event>& events) {
  if (isOutside(leaf.box, edge)) return 0;
  Tracer tracer(edge, leafIndex, events);
  if (const auto* polygon = std::get_if<Polygon>(&leaf.set)) {
    trace(*polygon, edge, tracer);
  } else if (const auto* plane = std::get_if<HalfPlane>(&std::get<SmoothSet>(leaf.set))) {
    trace(*plane, edge, tracer);
  } else {
    trace(std::get<SmoothSet>(leaf.set), edge, tracer);
  }
  return tracer.state;
}

}  // namespace af2::dsl::shapes
