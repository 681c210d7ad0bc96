#include "dsl/shapes/path.h"

#include <algorithm>
#include <cmath>

#include "dsl/shapes/arc.h"
#include "engine/base/predicates.h"

namespace af2::dsl::shapes {
namespace {

/// The corners that two steps of a closed path share.
struct Neighbors {
  bool secondFollows = false;  ///< the second step begins where the first one ends
  bool firstFollows = false;
};

bool linesMeet(const Step& s, const Step& t, Neighbors neighbors) {
  if (neighbors.secondFollows && neighbors.firstFollows) return true;  // the path returns on itself
  if (neighbors.firstFollows) return linesMeet(t, s, {true, false});
  if (!neighbors.secondFollows) return segmentsMeet(s.from, s.to, t.from, t.to);
  // They share a corner, so they have other common points only if the path reverses there.
  return orientation(s.from, s.to, t.to) == Turn::Straight && dot(s.to - s.from, t.to - t.from) < 0;
}

/// Intersections of line s and arc t.
bool lineMeetsArc(const Step& s, const Step& t, Neighbors neighbors) {
  const Edge edge{s.from, s.to};
  const auto crossings = Crossing::withCircle(edge, circleOf(t));
  if (!crossings) return false;
  const Crossing start = Crossing::start(edge), end = Crossing::end(edge);
  for (const Crossing& at : {crossings->first, crossings->second}) {
    const int fromStart = at.compare(start, edge), fromEnd = at.compare(end, edge);
    if (fromStart < 0 || fromEnd > 0) continue;
    if (neighbors.firstFollows && fromStart == 0) continue;
    if (neighbors.secondFollows && fromEnd == 0) continue;
    if (at.sideOf(chordOf(t), edge) >= 0) return true;
  }
  return false;
}

bool stepsMeet(const Step& s, const Step& t, Neighbors neighbors) {
  if (!s.via && !t.via) return linesMeet(s, t, neighbors);
  if (!s.via) return lineMeetsArc(s, t, neighbors);
  if (!t.via) return lineMeetsArc(t, s, {neighbors.firstFollows, neighbors.secondFollows});
  return arcsMeet(s, t, neighbors.secondFollows, neighbors.firstFollows);
}

/// Whether two corners of the path are at the same position.
bool repeatsCorner(const std::vector<Step>& path) {
  std::vector<Point2> corners;
  for (const Step& step : path) corners.push_back(step.from);
  std::sort(corners.begin(), corners.end(),
            [](Point2 p, Point2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  return std::adjacent_find(corners.begin(), corners.end()) != corners.end();
}

/// The orientation at the lowest of the leftmost corners, which is a convex corner of a simple
/// polygon.
Turn turnOf(const std::vector<Step>& path) {
  const auto isFirst = [](const Step& s, const Step& t) {
    return s.from.x < t.from.x || (s.from.x == t.from.x && s.from.y < t.from.y);
  };
  const auto extreme = std::min_element(path.begin(), path.end(), isFirst);
  const Step& before = extreme == path.begin() ? path.back() : *(extreme - 1);
  return orientation(before.from, extreme->from, extreme->to);
}

}  // namespace

std::optional<std::vector<Step>> stepsOf(const Shape& poly) {
  std::vector<Step> path;
  if (poly.points().empty()) return path;
  Point2 from = poly.points().back();
  std::size_t next = 0;
  for (const bool isArc : poly.arcs()) {
    Step step{from, {}, std::nullopt};
    if (isArc) step.via = poly.points()[next++];
    step.to = from = poly.points()[next++];
    if (step.via && orientation(step.from, *step.via, step.to) == Turn::Straight) {
      if (!liesBetween(*step.via, step.from, step.to)) return std::nullopt;
      step.via.reset();
    }
    if (step.from != step.to) path.push_back(step);
  }
  return path;
}

bool isSimple(const std::vector<Step>& path) {
  const std::size_t count = path.size();
  if (count < 2 || repeatsCorner(path)) return false;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (stepsMeet(path[i], path[j], {j == i + 1, i == 0 && j + 1 == count})) return false;
  return true;
}

double windingOf(const std::vector<Step>& path) {
  double area = 0;
  bool straight = true;
  for (const Step& step : path) {
    area += cross(step.from - path[0].from, step.to - path[0].from);
    if (!step.via) continue;
    area += 2 * areaBesideChord(step);
    straight = false;
  }
  if (!straight) return area;
  // `area` is rounded, so its sign comes from the exact orientation at a corner, unless that corner
  // is straight.
  const Turn turn = turnOf(path);
  return turn == Turn::Straight ? area : static_cast<int>(turn) * std::abs(area);
}

}  // namespace af2::dsl::shapes
