#include "engine/run/region_cuts.h"

#include <array>
#include <optional>

#include "engine/base/predicates.h"
#include "engine/base/turn.h"

namespace af2::region {
namespace {

/// Minimum distance, in wanted lengths, between a cut and the boundary, except near its ends.
constexpr double kClearance = 2.5;
/// Positions at which cuts are tried, as fractions of the region's extent: the middle first.
constexpr std::array<double, 9> kPositions{0.5, 0.45, 0.55, 0.4, 0.6, 0.35, 0.65, 0.3, 0.7};

/// Where a line x = position or y = position crosses a boundary edge.
struct Crossing {
  double along;  ///< coordinate along the line
  Spot start;    ///< the edge begins here
};

class Bisector {
 public:
  Bisector(const SurfaceEvaluator& surface, const SizeField& size, CutEnds ends)
      : surface_(surface), size_(size), ends_(ends) {}

  /// The cuts along the best line, none if no line is suitable.
  std::vector<Cut> bisect(const Loops& loops, const Plane& plane) {
    loops_ = &loops;
    plane_ = plane;
    Box box;
    forEachEdge(loops,
                [&](const BoundaryCorner& c, const BoundaryCorner&) { box.include(plane.at(c)); });
    const bool isWide = box.high.x - box.low.x >= box.high.y - box.low.y;
    for (const bool acrossX : {isWide, !isWide}) {
      for (double part : kPositions) {
        const double low = acrossX ? box.low.x : box.low.y,
                     high = acrossX ? box.high.x : box.high.y;
        std::vector<Cut> cuts = cutsAlong(acrossX, low + part * (high - low));
        if (!cuts.empty()) return cuts;
      }
    }
    return {};
  }

 private:
  const BoundaryCorner& at(Spot s) const { return (*loops_)[s.loop][s.corner]; }
  Spot next(Spot s) const { return {s.loop, (s.corner + 1) % (*loops_)[s.loop].size()}; }

  std::vector<Cut> cutsAlong(bool acrossX, double position) const {
    const std::vector<Crossing> crossings = crossingsWith(acrossX, position);
    if (crossings.empty() || crossings.size() % 2 != 0) return {};
    std::vector<Cut> cuts;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const Spot from = nearestEnd(crossings[i], acrossX, position);
      const Point2 start = plane_.at(at(from));
      const double aim = ends_ == CutEnds::Nearest ? position : acrossX ? start.x : start.y;
      const auto cut = cutBetween(from, nearestEnd(crossings[i + 1], acrossX, aim));
      if (!cut) return {};
      cuts.push_back(*cut);
    }
    return areDisjoint(cuts) ? cuts : std::vector<Cut>{};
  }

  std::vector<Crossing> crossingsWith(bool acrossX, double position) const {
    std::vector<Crossing> crossings;
    for (std::size_t l = 0; l < loops_->size(); ++l) {
      for (std::size_t i = 0; i < (*loops_)[l].size(); ++i) {
        const Spot spot{l, i};
        const Point2 p = plane_.at(at(spot)), q = plane_.at(at(next(spot)));
        const double p0 = acrossX ? p.x : p.y, q0 = acrossX ? q.x : q.y;
        if ((p0 < position) == (q0 < position)) continue;
        const double t = (position - p0) / (q0 - p0);
        const double p1 = acrossX ? p.y : p.x, q1 = acrossX ? q.y : q.x;
        crossings.push_back({p1 + t * (q1 - p1), spot});
      }
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& c, const Crossing& d) { return c.along < d.along; });
    return crossings;
  }

  Spot nearestEnd(const Crossing& crossing, bool acrossX, double position) const {
    const Spot end = next(crossing.start);
    const auto away = [&](Spot s) {
      const Point2 p = plane_.at(at(s));
      return std::abs((acrossX ? p.x : p.y) - position);
    };
    return away(crossing.start) <= away(end) ? crossing.start : end;
  }

  std::optional<Cut> cutBetween(Spot from, Spot to) const {
    // A line around a tube returns to its start vertex; the cut then ends at the next vertex.
    if (from != to && at(from).vertex == at(to).vertex) to = next(to);
    if (from == to || at(from).vertex == at(to).vertex) return std::nullopt;
    const Point2 p = plane_.at(at(from)), q = plane_.at(at(to));
    if (!leavesInside(from, q) || !leavesInside(to, p) || meetsBoundary(from, to))
      return std::nullopt;
    const CutLine line(at(from).point, at(to).point, surface_, size_);
    const auto edges = static_cast<std::size_t>(std::max(1l, std::lround(line.wantedEdges())));
    Cut cut{from, to, line.divided(edges)};
    if (cut.edges() < kFewestCutEdges || !isClear(cut)) return std::nullopt;
    return cut;
  }

  /// Whether the direction to `target` points well into the region: at least 40 degrees away from
  /// both edges of the corner.
  bool leavesInside(Spot spot, Point2 target) const {
    constexpr double kMinAngle = 0.7;
    const Loop& loop = (*loops_)[spot.loop];
    const Point2 center = plane_.at(at(spot));
    const Point2 out = plane_.at(at(next(spot))) - center;
    const Point2 back = plane_.at(loop[(spot.corner + loop.size() - 1) % loop.size()]) - center;
    const Point2 d = target - center;
    const double free = turnBetween(out, back), own = turnBetween(out, d);
    return own > kMinAngle && own < free - kMinAngle;
  }

  bool meetsBoundary(Spot from, Spot to) const {
    const Point2 p = plane_.at(at(from)), q = plane_.at(at(to));
    for (std::size_t l = 0; l < loops_->size(); ++l) {
      for (std::size_t i = 0; i < (*loops_)[l].size(); ++i) {
        const Spot start{l, i}, end = next(start);
        if (start == from || start == to || end == from || end == to) continue;
        if (segmentsMeet(p, q, plane_.at(at(start)), plane_.at(at(end)))) return true;
      }
    }
    return false;
  }

  bool isClear(const Cut& cut) const {
    const Point2 p = plane_.at(at(cut.from)), q = plane_.at(at(cut.to));
    const Point2 direction = (1 / distance(p, q)) * (q - p);
    double longest = 0;
    for (const SurfacePoint& x : cut.inner) longest = std::max(longest, size_.sizeAt(x));
    const double reach = 4 * kClearance * longest;  // lengths in the plane are approximate
    std::vector<const BoundaryCorner*> near;
    forEachEdge(*loops_, [&](const BoundaryCorner& c, const BoundaryCorner&) {
      const Point2 d = plane_.at(c) - p;
      const double along = dot(d, direction);
      if (std::abs(cross(direction, d)) < reach && along > -reach && along < distance(p, q) + reach)
        near.push_back(&c);
    });
    const Point3 start = at(cut.from).point.position, end = at(cut.to).point.position;
    for (const SurfacePoint& x : cut.inner) {
      const double toEnds = std::min(distance(x.position, start), distance(x.position, end));
      // Near its ends a cut is necessarily close to the neighbouring boundary vertices.
      const double wanted = std::min(kClearance * size_.sizeAt(x), 0.6 * toEnds);
      for (const BoundaryCorner* c : near)
        if (distance(c->point.position, x.position) < wanted) return false;
    }
    return true;
  }

  static bool areDisjoint(const std::vector<Cut>& cuts) {
    std::vector<Spot> ends;
    for (const Cut& cut : cuts) {
      for (Spot s : {cut.from, cut.to}) {
        if (std::find(ends.begin(), ends.end(), s) != ends.end()) return false;
        ends.push_back(s);
      }
    }
    return true;
  }

  const SurfaceEvaluator& surface_;
  const SizeField& size_;
  const CutEnds ends_;
  const Loops* loops_ = nullptr;
  Plane plane_;
};

}  // namespace

CutLine::CutLine(const SurfacePoint& from, const SurfacePoint& to, const SurfaceEvaluator& surface,
                 const SizeField& size)
    : from_(from), to_(to), surface_(surface) {
  const double roughly =
      distance(from.position, to.position) / std::min(size.sizeAt(from), size.sizeAt(to));
  samples_ = static_cast<int>(std::clamp(2 * roughly, 32.0, 20000.0));
  SurfacePoint last = from;
  for (int i = 1; i <= samples_; ++i) {
    const SurfacePoint p = i == samples_ ? to : pointAt(static_cast<double>(i) / samples_);
    const double wanted = 0.5 * (size.sizeAt(last) + size.sizeAt(p));
    sum_.push_back(sum_.back() + distance(last.position, p.position) / wanted);
    last = p;
  }
}

std::vector<SurfacePoint> CutLine::divided(std::size_t edges) const {
  std::vector<SurfacePoint> inner;
  for (std::size_t k = 1; k < edges; ++k) {
    const double target = sum_.back() * static_cast<double>(k) / static_cast<double>(edges);
    const auto above = std::lower_bound(sum_.begin(), sum_.end(), target);
    const auto i = static_cast<std::size_t>(above - sum_.begin());
    const double t =
        (static_cast<double>(i) - (sum_[i] - target) / (sum_[i] - sum_[i - 1])) / samples_;
    inner.push_back(pointAt(t));
  }
  return inner;
}

SurfacePoint CutLine::pointAt(double t) const {
  return surface_.at(from_.u + t * (to_.u - from_.u), from_.v + t * (to_.v - from_.v));
}

std::vector<Cut> findCuts(const Loops& loops, const Plane& plane, const SurfaceEvaluator& surface,
                          const SizeField& size, CutEnds ends) {
  return Bisector(surface, size, ends).bisect(loops, plane);
}

}  // namespace af2::region
