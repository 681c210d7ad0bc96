// Whether a region is bounded, and a box that contains it.
#include <algorithm>
#include <cmath>

#include "dsl/shapes/boundary.h"
#include "dsl/shapes/build.h"

namespace af2::dsl::shapes {
namespace {

/// A half plane of a region. Far enough out, only half planes matter.
struct Unbounded {
  std::size_t leaf;
  const HalfPlane* plane;
};

std::vector<Unbounded> halfPlanesOf(const Region& region) {
  std::vector<Unbounded> planes;
  for (std::size_t i = 0; i < region.leaves().size(); ++i) {
    const auto* set = std::get_if<SmoothSet>(&region.leaves()[i].set);
    if (const auto* plane = set ? std::get_if<HalfPlane>(set) : nullptr)
      planes.push_back({i, plane});
  }
  return planes;
}

/// Far out in one direction, the parallel lines divide the plane into lanes. Visits the lanes from
/// right to left. `ahead` is a half plane whose line has this direction.
bool reachesInfinity(const Region& region, const std::vector<Unbounded>& planes,
                     const HalfPlane& ahead) {
  std::vector<std::uint8_t> states(region.leaves().size(), 0);
  std::vector<Unbounded> lanes;
  for (const Unbounded& one : planes) {
    const int turn = turnOf(*one.plane, ahead);
    if (turn == 0) lanes.push_back(one);
    const bool isIn = turn != 0 ? turn > 0 : !headsAlong(*one.plane, ahead);
    states[one.leaf] = isIn ? kBothSides : 0;
  }
  const auto isRightOf = [&ahead](const Unbounded& p, const Unbounded& q) {
    HalfPlane line = ahead;
    line.point = q.plane->point;
    return sideOf(line, p.plane->point) < 0;
  };
  std::stable_sort(lanes.begin(), lanes.end(), isRightOf);
  if (region.combine(states) != 0) return true;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    states[lanes[i].leaf] ^= kBothSides;
    const bool endsLane = i + 1 == lanes.size() || isRightOf(lanes[i], lanes[i + 1]);
    if (endsLane && region.combine(states) != 0) return true;
  }
  return false;
}

/// The rounded crossing of the lines of two half planes; nothing if there is none, or if it is too
/// far away to matter.
std::optional<Point2> crossingOf(const HalfPlane& p, const HalfPlane& q) {
  const Point2 u = p.tip - p.tail, v = q.tip - q.tail;
  const double det = cross(u, v);
  if (det == 0) return std::nullopt;
  const Point2 point = p.point + (cross(q.point - p.point, v) / det) * u;
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) return std::nullopt;
  return point;
}

void include(Box2& box, Point2 point, double margin) {
  box.low = {std::min(box.low.x, point.x - margin), std::min(box.low.y, point.y - margin)};
  box.high = {std::max(box.high.x, point.x + margin), std::max(box.high.y, point.y + margin)};
}

}  // namespace

bool isBounded(const Region& region) {
  const auto planes = halfPlanesOf(region);
  return std::none_of(planes.begin(), planes.end(), [&](const Unbounded& one) {
    HalfPlane back = *one.plane;
    std::swap(back.tail, back.tip);
    return reachesInfinity(region, planes, *one.plane) || reachesInfinity(region, planes, back);
  });
}

/// Every vertex of the region is on a disc or polygon, or at the crossing of two lines.
Box2 finiteBox(const Region& region, const Box2& box) {
  constexpr double kMargin = 1e-9;  // relative; covers the rounding of the crossings
  if (std::isfinite(box.low.x + box.low.y + box.high.x + box.high.y)) return box;
  Box2 result{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Leaf& leaf : region.leaves()) {
    if (!std::isfinite(leaf.box.low.x + leaf.box.high.x + leaf.box.low.y + leaf.box.high.y))
      continue;
    include(result, leaf.box.low, 0);
    include(result, leaf.box.high, 0);
  }
  const auto planes = halfPlanesOf(region);
  for (const Unbounded& p : planes)
    for (const Unbounded& q : planes)
      if (const auto point = crossingOf(*p.plane, *q.plane))
        include(result, *point, kMargin * (1 + length(*point)));
  return result;
}

}  // namespace af2::dsl::shapes
