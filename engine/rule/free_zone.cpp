#include "engine/rule/free_zone.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/error.h"
#include "engine/base/predicates.h"

namespace af2 {
namespace {

/// Whether an edge direction points into the upper half plane. Along a convex counter-clockwise
/// polygon this changes exactly twice.
bool pointsUp(Point2 d) { return d.y > 0 || (d.y == 0 && d.x > 0); }

/// Removes corner `index` of `count`, keeping the order of the others.
void drop(Point2* corners, int& count, int index) {
  std::copy(corners + index + 1, corners + count, corners + index);
  --count;
}

int dropRepetitions(Point2* corners, int count) {
  const auto end = std::unique(corners, corners + count);
  count = static_cast<int>(end - corners);
  while (count > 1 && corners[count - 1] == corners[0]) --count;
  return count;
}

/// Whether a point with orientation `turn` is beyond a line that has the polygon on its other side.
bool isBeyond(Turn turn, Turn side, ZoneBoundary boundary) {
  return turn == side || (turn == Turn::Straight && boundary == ZoneBoundary::Ignored);
}

/// How far q lies inside the chord from p to r; > 0 for a reflex corner.
double reflexDepth(Point2 p, Point2 q, Point2 r) {
  const double chord = distance(p, r);
  return chord > 0 ? -cross(q - p, r - q) / chord : 0;
}

/// Largest distance of a corner from the first, along an axis; not finite if a coordinate is not.
double extentOf(const Point2* corners, int count) {
  double extent = 0, check = 0;
  for (int i = 0; i < count; ++i) {
    const Point2 d = corners[i] - corners[0];
    extent = std::max({extent, std::abs(d.x), std::abs(d.y)});
    check += 0 * d.x + 0 * d.y;  // std::max ignores NaN
  }
  return extent + check;
}

}  // namespace

int convex_polygon::normalize(Point2* corners, int count, double straightTolerance) {
  const double tolerance = straightTolerance * std::min(extentOf(corners, count), 1.0);
  if (!std::isfinite(tolerance)) return 0;
  count = dropRepetitions(corners, count);
  bool hasLeftTurn = false;
  // Goes round until every corner has passed the test since the last one was removed.
  for (int i = 0, good = 0; good < count && count >= 3;) {
    const Point2 p = corners[i == 0 ? count - 1 : i - 1], q = corners[i];
    const Point2 r = corners[i + 1 == count ? 0 : i + 1];
    const Turn turn = orientation(p, q, r);
    const bool runsBack = turn != Turn::Left && dot(q - p, r - q) < 0;
    if (!runsBack && turn != Turn::Right) {
      hasLeftTurn = hasLeftTurn || turn == Turn::Left;
      ++good;
      i = i + 1 == count ? 0 : i + 1;
      continue;
    }
    // A corner at which the polygon turns straight back is not a valid corner, unless rounding has
    // swapped two corners that should coincide.
    if (runsBack ? std::min(distance(p, q), distance(q, r)) > tolerance
                 : !(reflexDepth(p, q, r) <= tolerance))
      return 0;
    drop(corners, count, i);
    i = i == 0 ? count - 1 : i - 1;
    good = 0;
    hasLeftTurn = false;
  }
  if (count < 3 || !hasLeftTurn) return 0;
  int changes = 0;
  for (int i = 0; i < count; ++i) {
    const Point2 p = corners[i == 0 ? count - 1 : i - 1], q = corners[i];
    changes += pointsUp(q - p) != pointsUp(corners[i + 1 == count ? 0 : i + 1] - q);
  }
  return changes <= 2 ? count : 0;
}

bool convex_polygon::contains(std::span<const Point2> corners, Point2 point,
                              ZoneBoundary boundary) {
  Point2 p = corners.back();
  for (Point2 q : corners) {
    const Turn turn = orientation(p, q, point);
    if (turn == Turn::Right) return false;
    if (turn == Turn::Straight && boundary == ZoneBoundary::Ignored) return false;
    p = q;
  }
  return true;
}

bool convex_polygon::meets(std::span<const Point2> corners, Point2 from, Point2 to,
                           ZoneBoundary boundary) {
  if (from == to) return contains(corners, from, boundary);
  // Two convex sets are disjoint if and only if a line along an edge of one separates them.
  Point2 p = corners.back();
  for (Point2 q : corners) {
    if (isBeyond(orientation(p, q, from), Turn::Right, boundary) &&
        isBeyond(orientation(p, q, to), Turn::Right, boundary))
      return false;
    p = q;
  }
  return meetsLine(corners, from, to, boundary);
}

bool convex_polygon::meetsLine(std::span<const Point2> corners, Point2 from, Point2 to,
                               ZoneBoundary boundary) {
  bool allLeft = true, allRight = true;
  for (Point2 q : corners) {
    const Turn turn = orientation(from, to, q);
    allLeft = allLeft && isBeyond(turn, Turn::Left, boundary);
    allRight = allRight && isBeyond(turn, Turn::Right, boundary);
    if (!allLeft && !allRight) break;
  }
  if (allLeft || allRight) return false;
  if (boundary == ZoneBoundary::Ignored) return true;
  // Where touching counts, a segment in line with an edge may still end before the polygon begins.
  if (contains(corners, from, boundary) || contains(corners, to, boundary)) return true;
  Point2 p = corners.back();
  for (Point2 q : corners) {
    if (segmentsMeet(from, to, p, q)) return true;
    p = q;
  }
  return false;
}

bool ConvexPolygonZone::isConvex(std::span<const Point2> given, double straightTolerance) {
  std::vector<Point2> corners(given.begin(), given.end());
  return convex_polygon::normalize(corners.data(), static_cast<int>(corners.size()),
                                   straightTolerance) > 0;
}

ConvexPolygonZone::ConvexPolygonZone(std::vector<Point2> corners) : corners_(std::move(corners)) {
  const int count = convex_polygon::normalize(corners_.data(), static_cast<int>(corners_.size()));
  if (count == 0)
    throw InputError("free zone: the corners do not run counter-clockwise around a convex region");
  corners_.resize(static_cast<std::size_t>(count));
}

Box2 ConvexPolygonZone::boundingBox() const {
  Box2 box{corners_[0], corners_[0]};
  for (Point2 p : corners_) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool ConvexPolygonZone::contains(Point2 point, ZoneBoundary boundary) const {
  return convex_polygon::contains(corners_, point, boundary);
}

bool ConvexPolygonZone::meets(Point2 from, Point2 to, ZoneBoundary boundary) const {
  return convex_polygon::meets(corners_, from, to, boundary);
}

ConvexPolygonZoneDef::ConvexPolygonZoneDef(std::vector<Corner> corners, std::vector<double> fade)
    : corners_(std::move(corners)), fade_(std::move(fade)) {
  if (corners_.size() < 3)
    throw InputError("free zone: " + std::to_string(corners_.size()) +
                     " corners; a polygon needs at least three");
  if (fade_.empty()) throw InputError("free zone: no fade is given");
  for (const Corner& corner : corners_)
    if (!corner.preferred) throw InputError("free zone: a corner has no preferred position");
}

double ConvexPolygonZoneDef::fade(int level) const {
  const auto last = static_cast<int>(fade_.size()) - 1;
  return fade_[static_cast<std::size_t>(std::clamp(level - 1, 0, last))];
}

std::optional<std::vector<Point2>> ConvexPolygonZoneDef::cornersAt(
    const AF2Binding& binding) const {
  const double t = fade(binding.level);
  std::vector<Point2> corners;
  corners.reserve(corners_.size());
  for (const Corner& corner : corners_) {
    const auto preferred = corner.preferred->transformPoint(binding);
    const auto limiting = corner.limiting ? corner.limiting->transformPoint(binding) : preferred;
    if (!preferred || !limiting) return std::nullopt;
    // Without a limiting corner the preferred one is used unchanged: corners that are matched
    // vertices must keep their coordinates bit for bit.
    corners.push_back(corner.limiting ? t * *preferred + (1 - t) * *limiting : *preferred);
  }
  return corners;
}

AF2FreeZoneDef::Made ConvexPolygonZoneDef::makeFreeZone(const AF2Binding& binding) const {
  auto corners = cornersAt(binding);
  if (!corners) return {nullptr, Refusal::NoValue};
  if (!ConvexPolygonZone::isConvex(*corners)) return {nullptr, Refusal::Convexity};
  return {std::make_unique<ConvexPolygonZone>(std::move(*corners)), Refusal::None};
}

}  // namespace af2
