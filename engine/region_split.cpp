#include "engine/region_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/error.h"
#include "engine/predicates.h"

namespace af2 {
namespace {

/// A cut keeps this distance, in wanted lengths, from the boundary but near its own ends.
constexpr double kClearance = 2.5;
/// A cut with fewer edges than this would be all ends.
constexpr int kFewestEdges = 5;
/// Where cuts are tried, as parts of the extent of the region: the middle first.
constexpr std::array<double, 9> kPositions{0.5, 0.45, 0.55, 0.4, 0.6, 0.35, 0.65, 0.3, 0.7};
constexpr double kUnitTriangle = 0.4330127018922193;  // area of the one with edges of length 1

using Loop = std::vector<BoundaryCorner>;
using Loops = std::vector<Loop>;

/// The parameter plane stretched so that lengths in it are about lengths on the surface.
struct Plane {
  double scaleU = 1, scaleV = 1;
  Point2 at(const BoundaryCorner& c) const { return {scaleU * c.point.u, scaleV * c.point.v}; }
};

struct Box {
  Point2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  void include(Point2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

template <class Visit>
void forEachEdge(const Loops& loops, Visit&& visit) {
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t i = 0; i < loops[l].size(); ++i)
      visit(loops[l][i], loops[l][(i + 1) % loops[l].size()]);
}

double signedArea(const Loop& loop, const Plane& plane) {
  double twice = 0;
  const Point2 origin = plane.at(loop[0]);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    twice += cross(plane.at(loop[i]) - origin, plane.at(loop[i + 1]) - origin);
  return 0.5 * twice;
}

/// One corner of one loop.
struct Spot {
  std::size_t loop = 0, corner = 0;
  bool operator==(const Spot&) const = default;
};

/// A cut to be: a straight line in the parameter plane between two corners, and its inner vertices.
struct Cut {
  Spot from, to;
  std::vector<SurfacePoint> inner;
};

/// Where a line x = position or y = position crosses a boundary edge.
struct Crossing {
  double along;  ///< coordinate along the line
  Spot start;    ///< the edge begins here
};

class Bisector {
 public:
  Bisector(const SurfaceEvaluator& surface, const SizeField& size)
      : surface_(surface), size_(size) {}

  /// The cuts of the best line, none if no line will do.
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
      const auto cut = cutBetween(nearestEnd(crossings[i], acrossX, position),
                                  nearestEnd(crossings[i + 1], acrossX, position));
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
    if (from == to || at(from).vertex == at(to).vertex) return std::nullopt;
    const Point2 p = plane_.at(at(from)), q = plane_.at(at(to));
    if (!leavesInside(from, q) || !leavesInside(to, p) || meetsBoundary(from, to))
      return std::nullopt;
    Cut cut{from, to, innerVertices(at(from).point, at(to).point)};
    if (static_cast<int>(cut.inner.size()) + 1 < kFewestEdges || !isClear(cut)) return std::nullopt;
    return cut;
  }

  /// Whether the direction to `target` leaves a corner well inside the region: at no less than 40
  /// degrees to both of its edges.
  bool leavesInside(Spot spot, Point2 target) const {
    constexpr double kLeastAngle = 0.7;
    const Loop& loop = (*loops_)[spot.loop];
    const Point2 center = plane_.at(at(spot));
    const Point2 out = plane_.at(at(next(spot))) - center;
    const Point2 back = plane_.at(loop[(spot.corner + loop.size() - 1) % loop.size()]) - center;
    const Point2 d = target - center;
    const auto angleFrom = [](Point2 a, Point2 b) {
      const double angle = std::atan2(cross(a, b), dot(a, b));
      return angle > 0 ? angle : angle + 2 * M_PI;
    };
    const double free = angleFrom(out, back), own = angleFrom(out, d);
    return own > kLeastAngle && own < free - kLeastAngle;
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

  /// Vertices at equal steps of length over wanted length.
  std::vector<SurfacePoint> innerVertices(const SurfacePoint& from, const SurfacePoint& to) const {
    const auto pointAt = [&](double t) {
      return surface_.at(from.u + t * (to.u - from.u), from.v + t * (to.v - from.v));
    };
    const double roughly =
        distance(from.position, to.position) / std::min(size_.sizeAt(from), size_.sizeAt(to));
    const int samples = std::clamp(static_cast<int>(2 * roughly), 32, 20000);
    std::vector<double> sum{0};
    SurfacePoint last = from;
    for (int i = 1; i <= samples; ++i) {
      const SurfacePoint p = i == samples ? to : pointAt(static_cast<double>(i) / samples);
      const double wanted = 0.5 * (size_.sizeAt(last) + size_.sizeAt(p));
      sum.push_back(sum.back() + distance(last.position, p.position) / wanted);
      last = p;
    }
    const int edges = std::max(1, static_cast<int>(std::lround(sum.back())));
    std::vector<SurfacePoint> inner;
    for (int k = 1; k < edges; ++k) {
      const double target = sum.back() * k / edges;
      const auto above = std::lower_bound(sum.begin(), sum.end(), target);
      const auto i = static_cast<std::size_t>(above - sum.begin());
      const double t =
          (static_cast<double>(i) - (sum[i] - target) / (sum[i] - sum[i - 1])) / samples;
      inner.push_back(pointAt(t));
    }
    return inner;
  }

  bool isClear(const Cut& cut) const {
    const Point2 p = plane_.at(at(cut.from)), q = plane_.at(at(cut.to));
    const Point2 direction = (1 / distance(p, q)) * (q - p);
    double longest = 0;
    for (const SurfacePoint& x : cut.inner) longest = std::max(longest, size_.sizeAt(x));
    const double reach = 4 * kClearance * longest;  // lengths in the plane are only about right
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
      // Near its own ends a cut that leaves steeply comes as close to its neighbours as it must.
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
  const Loops* loops_ = nullptr;
  Plane plane_;
};

/// Links the loops anew along the cuts: at each end of a cut the way in goes on along it.
Loops relink(const Loops& loops, const std::vector<Cut>& cuts, std::size_t firstCutVertex) {
  std::vector<std::size_t> first(loops.size() + 1, 0);
  for (std::size_t l = 0; l < loops.size(); ++l) first[l + 1] = first[l] + loops[l].size();
  std::vector<BoundaryCorner> corners;
  std::vector<std::size_t> next;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (std::size_t i = 0; i < loops[l].size(); ++i) {
      corners.push_back(loops[l][i]);
      next.push_back(first[l] + (i + 1) % loops[l].size());
    }
  }
  std::vector<std::size_t> previous(next.size());
  for (std::size_t i = 0; i < next.size(); ++i) previous[next[i]] = i;

  const auto add = [&](const BoundaryCorner& corner, std::size_t after) {
    corners.push_back(corner);
    next.push_back(0);
    if (after < corners.size() - 1) next[after] = corners.size() - 1;
    return corners.size() - 1;
  };
  std::size_t id = firstCutVertex;
  for (const Cut& cut : cuts) {
    const std::size_t a = first[cut.from.loop] + cut.from.corner;
    const std::size_t b = first[cut.to.loop] + cut.to.corner;
    // before a -> a' -> cut -> b -> after b, and before b -> b' -> cut reversed -> a -> after a
    const std::size_t beforeA = previous[a], beforeB = previous[b];
    const std::size_t a2 = add(corners[a], beforeA);
    std::size_t last = a2;
    for (std::size_t k = 0; k < cut.inner.size(); ++k)
      last = add({VertexId(id + k), cut.inner[k]}, last);
    next[last] = b;
    const std::size_t b2 = add(corners[b], beforeB);
    last = b2;
    for (std::size_t k = cut.inner.size(); k-- > 0;)
      last = add({VertexId(id + k), cut.inner[k]}, last);
    next[last] = a;
    id += cut.inner.size();
  }

  Loops result;
  std::vector<bool> isDone(corners.size(), false);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (isDone[i]) continue;
    result.emplace_back();
    for (std::size_t k = i; !isDone[k]; k = next[k]) {
      isDone[k] = true;
      result.back().push_back(corners[k]);
    }
  }
  return result;
}

bool encloses(const Loop& outer, Point2 p, const Plane& plane) {
  bool isInside = false;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    Point2 a = plane.at(outer[i]), b = plane.at(outer[(i + 1) % outer.size()]);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.y > b.y) std::swap(a, b);
    if (orientation(a, b, p) == Turn::Left) isInside = !isInside;
  }
  return isInside;
}

/// Outer loops, each with the holes that lie in it; nothing if a hole lies in none.
std::vector<Loops> regionsOf(Loops loops, const Plane& plane, bool isReversed) {
  std::vector<Loops> regions;
  std::vector<Loop> holes;
  std::vector<double> areas;
  for (Loop& loop : loops) {
    const double area = signedArea(loop, plane) * (isReversed ? -1 : 1);
    if (area > 0) {
      regions.push_back({std::move(loop)});
      areas.push_back(area);
    } else {
      holes.push_back(std::move(loop));
    }
  }
  for (Loop& hole : holes) {
    std::size_t home = regions.size();
    for (std::size_t r = 0; r < regions.size(); ++r)
      if (encloses(regions[r][0], plane.at(hole[0]), plane) &&
          (home == regions.size() || areas[r] < areas[home]))
        home = r;
    if (home == regions.size()) return {};
    regions[home].push_back(std::move(hole));
  }
  return regions;
}

class Splitter {
 public:
  Splitter(const FrontInput& input, const SurfaceEvaluator& surface, const SizeField& size,
           const SplitOptions& options)
      : input_(input), surface_(surface), size_(size), options_(options) {}

  SplitRegion split() {
    double area = 0;
    for (const Loop& loop : input_.loops) area += signedArea(loop, Plane{});
    isReversed_ = area < 0;
    // Where isolated vertices go would need a rule of its own; they are rare.
    if (input_.isolated.empty()) recurse(input_.loops);
    if (result_.pieces.size() <= 1) result_.pieces = {whole()};
    return std::move(result_);
  }

 private:
  void recurse(const Loops& loops) {
    const Plane plane = planeFor(loops);
    if (expectedElements(loops, plane) > options_.pieceElements) {
      std::vector<Cut> cuts = tryToCut(loops, plane);
      if (!cuts.empty()) {
        const std::size_t firstId = input_.vertexCount + result_.cutVertices.size();
        const std::vector<Loops> parts =
            regionsOf(relink(loops, cuts, firstId), plane, isReversed_);
        if (parts.size() > 1) {
          for (const Cut& cut : cuts)
            result_.cutVertices.insert(result_.cutVertices.end(), cut.inner.begin(),
                                       cut.inner.end());
          for (const Loops& part : parts) recurse(part);
          return;
        }
      }
    }
    result_.pieces.push_back(pieceOf(loops));
  }

  std::vector<Cut> tryToCut(const Loops& loops, const Plane& plane) const {
    try {
      // A reversed face is drawn in the mirror: region on the right. Swapping u and v puts it
      // right.
      if (!isReversed_) return Bisector(surface_, size_).bisect(loops, plane);
      const Mirror mirror(surface_);
      const MirrorSize mirrorSize(size_);
      Loops mirrored = loops;
      for (Loop& loop : mirrored)
        for (BoundaryCorner& c : loop) std::swap(c.point.u, c.point.v);
      std::vector<Cut> cuts =
          Bisector(mirror, mirrorSize).bisect(mirrored, {plane.scaleV, plane.scaleU});
      for (Cut& cut : cuts)
        for (SurfacePoint& p : cut.inner) std::swap(p.u, p.v);
      return cuts;
    } catch (const GeometryError&) {
      return {};  // a line through a place without a normal: the region stays whole
    }
  }

  class Mirror final : public SurfaceEvaluator {
   public:
    explicit Mirror(const SurfaceEvaluator& surface) : surface_(surface) {}
    SurfacePoint at(double u, double v) const override {
      SurfacePoint p = surface_.at(v, u);
      std::swap(p.u, p.v);
      return p;
    }

   private:
    const SurfaceEvaluator& surface_;
  };

  class MirrorSize final : public SizeField {
   public:
    explicit MirrorSize(const SizeField& size) : size_(size) {}
    double sizeAt(const SurfacePoint& point) const override {
      SurfacePoint p = point;
      std::swap(p.u, p.v);
      return size_.sizeAt(p);
    }

   private:
    const SizeField& size_;
  };

  /// Lengths of the parameter lines through the middle of the region.
  Plane planeFor(const Loops& loops) const {
    Box box;
    forEachEdge(loops, [&](const BoundaryCorner& c, const BoundaryCorner&) {
      box.include({c.point.u, c.point.v});
    });
    const Point2 extent = box.high - box.low, middle = 0.5 * (box.low + box.high);
    if (!(extent.x > 0) || !(extent.y > 0)) return {};
    constexpr double kStep = 1e-3;
    try {
      const Point3 here = surface_.at(middle.x, middle.y).position;
      const double alongU =
          distance(here, surface_.at(middle.x + kStep * extent.x, middle.y).position);
      const double alongV =
          distance(here, surface_.at(middle.x, middle.y + kStep * extent.y).position);
      if (alongU > 0 && alongV > 0)
        return {alongU / (kStep * extent.x), alongV / (kStep * extent.y)};
    } catch (const GeometryError&) {
    }
    return {};
  }

  double expectedElements(const Loops& loops, const Plane& plane) const {
    double area = 0, lengths = 0, weights = 0;
    for (const Loop& loop : loops) area += signedArea(loop, plane);
    forEachEdge(loops, [&](const BoundaryCorner& c, const BoundaryCorner& d) {
      const double length = distance(c.point.position, d.point.position);
      lengths += length * size_.sizeAt(c.point);
      weights += length;
    });
    const double size = weights > 0 ? lengths / weights : 1;
    return std::abs(area) / (kUnitTriangle * size * size);
  }

  static RegionPiece pieceOf(const Loops& loops) {
    RegionPiece piece;
    forEachEdge(loops, [&](const BoundaryCorner& c, const BoundaryCorner&) {
      piece.vertices.push_back(c.vertex);
    });
    std::sort(piece.vertices.begin(), piece.vertices.end());
    piece.vertices.erase(std::unique(piece.vertices.begin(), piece.vertices.end()),
                         piece.vertices.end());
    piece.input.vertexCount = piece.vertices.size();
    piece.input.loops = loops;
    for (Loop& loop : piece.input.loops)
      for (BoundaryCorner& c : loop) c.vertex = localId(piece, c.vertex);
    return piece;
  }

  static VertexId localId(const RegionPiece& piece, VertexId id) {
    const auto at = std::lower_bound(piece.vertices.begin(), piece.vertices.end(), id);
    return VertexId(static_cast<std::size_t>(at - piece.vertices.begin()));
  }

  RegionPiece whole() const {
    RegionPiece piece{input_, {}};
    for (std::size_t v = 0; v < input_.vertexCount; ++v) piece.vertices.push_back(VertexId(v));
    return piece;
  }

  const FrontInput& input_;
  const SurfaceEvaluator& surface_;
  const SizeField& size_;
  const SplitOptions& options_;
  bool isReversed_ = false;
  SplitRegion result_;
};

}  // namespace

SplitRegion splitRegion(const FrontInput& input, const SurfaceEvaluator& surface,
                        const SizeField& size, const SplitOptions& options) {
  return Splitter(input, surface, size, options).split();
}

}  // namespace af2
