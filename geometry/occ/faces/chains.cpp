#include "geometry/occ/faces/chains.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "geometry/base/plane_axes.h"
#include "geometry/base/turns.h"
#include "geometry/mesh/sharp_seams.h"

namespace af2::geometry {

namespace {

/// A number that grows with the angle of a direction, from 0 to 4 for a full turn.
double pseudoAngle(Point2 d) {
  const double sum = std::abs(d.x) + std::abs(d.y);
  if (sum == 0) return 0;
  const double t = d.y / sum;
  if (d.x < 0) return 2 - t;
  return d.y < 0 ? 4 + t : t;
}

/// The direction from one vertex to another in the tangent plane of the first.
double angleTowards(const PlaneAxes& axes, const SurfacePoint& other) {
  return pseudoAngle(axes(other));
}

/// How far one turns clockwise from `from` to `to`, in (0, 4].
double clockwise(double from, double to) { return from > to ? from - to : from - to + 4; }

class Linker {
 public:
  explicit Linker(std::vector<Chain> chains) : chains_(std::move(chains)) {
    for (std::size_t i = 0; i < chains_.size(); ++i)
      starting_.push_back({chains_[i].corners.front().vertex, i});
    std::ranges::stable_sort(starting_, {}, &Start::vertex);
  }

  LinkedLoops link() {
    findParameterScale();
    std::vector<bool> used(chains_.size(), false);
    for (std::size_t i = 0; i < chains_.size(); ++i)
      if (!used[i]) result_.loops.push_back(follow(i, used));
    return std::move(result_);
  }

 private:
  struct Start {
    VertexId vertex;
    std::size_t chain;
  };

  std::vector<BoundaryCorner> follow(std::size_t first, std::vector<bool>& used) {
    std::vector<BoundaryCorner> loop;
    std::size_t i = first;
    do {
      used[i] = true;
      const auto& corners = chains_[i].corners;
      loop.insert(loop.end(), corners.begin(), corners.end() - 1);
      i = successor(i, first, used);
      compareParameters(corners.back().point, chains_[i].corners.front().point);
    } while (!used[i]);
    return loop;
  }

  void findParameterScale() {
    double u1 = 1e300, u2 = -1e300, v1 = 1e300, v2 = -1e300;
    for (const Chain& chain : chains_)
      for (const BoundaryCorner& corner : chain.corners) {
        u1 = std::min(u1, corner.point.u), u2 = std::max(u2, corner.point.u);
        v1 = std::min(v1, corner.point.v), v2 = std::max(v2, corner.point.v);
      }
    uTolerance_ = kSameParameter * (u2 - u1);
    vTolerance_ = kSameParameter * (v2 - v1);
  }

  void compareParameters(const SurfacePoint& end, const SurfacePoint& start) {
    if (std::abs(end.u - start.u) > uTolerance_ || std::abs(end.v - start.v) > vTolerance_)
      result_.jumps.push_back({end, start});
  }

  /// The chain that leaves the end of chain `i` next to it, clockwise; `first` closes the loop.
  std::size_t successor(std::size_t i, std::size_t first, const std::vector<bool>& used) const {
    const auto& corners = chains_[i].corners;
    const BoundaryCorner& end = corners.back();
    const PlaneAxes plane(end.point);
    const double back = angleTowards(plane, corners[corners.size() - 2].point);
    std::optional<std::size_t> best;
    double bestTurn = 0;
    const auto starting = std::ranges::equal_range(starting_, end.vertex, {}, &Start::vertex);
    const bool mayBeSharp = std::ranges::all_of(starting, [&](const Start& candidate) {
      return isOver(candidate.chain, first, used) || isSharpBetween(end, candidate.chain);
    });
    for (const auto& [vertex, candidate] : starting) {
      if (isOver(candidate, first, used)) continue;
      if (!mayBeSharp && isSharpBetween(end, candidate)) continue;
      const double turn = clockwise(back, angleTowards(plane, chains_[candidate].corners[1].point));
      if (best && turn >= bestTurn) continue;
      best = candidate;
      bestTurn = turn;
    }
    if (!best)
      throw GeometryError("the boundary is not closed: no edge follows edge " +
                          std::to_string(chains_[i].edge) + ", which ends at " +
                          textOf(end.point.position) + "; healing closes loops that lack an edge");
    return *best;
  }

  static bool isOver(std::size_t chain, std::size_t first, const std::vector<bool>& used) {
    return used[chain] && chain != first;
  }

  /// Whether a chain starts on another side of a sharp seam, where the tangent plane is another.
  bool isSharpBetween(const BoundaryCorner& end, std::size_t chain) const {
    return differSharply(end.point.normal, chains_[chain].corners.front().point.normal);
  }

  /// Share of the range of a parameter.
  static constexpr double kSameParameter = 1e-3;

  LinkedLoops result_;
  double uTolerance_ = 0, vTolerance_ = 0;
  std::vector<Chain> chains_;
  std::vector<Start> starting_;  // by vertex
};

/// Whether the region is on both sides of two opposite chains, that is, whether they are inside the
/// loops of the others. If the others are not closed in the plane, this is unknown, and the result
/// is false.
bool isSlit(const std::vector<Chain>& chains, std::size_t one, std::size_t other,
            const std::function<Point2(const SurfacePoint&)>& inPlane) {
  constexpr double kGap = 1e-3;  // of the length of what is drawn
  const auto& corners = chains[one].corners;
  const Point2 p = inPlane(corners[0].point), q = inPlane(corners[1].point);
  const Point2 place = 0.5 * (p + q);
  bool isInside = false;
  Point2 sum{0, 0};
  double drawn = 0;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (i == one || i == other) continue;
    for (std::size_t k = 0; k + 1 < chains[i].corners.size(); ++k) {
      const Point2 from = inPlane(chains[i].corners[k].point);
      const Point2 to = inPlane(chains[i].corners[k + 1].point);
      sum = sum + (to - from);
      drawn += distance(from, to);
      if ((from.y > place.y) == (to.y > place.y)) continue;
      const double x = from.x + (place.y - from.y) / (to.y - from.y) * (to.x - from.x);
      if (place.x < x) isInside = !isInside;
    }
  }
  return isInside && std::abs(sum.x) + std::abs(sum.y) < kGap * drawn;
}

}  // namespace

void cancelOppositeChains(std::vector<Chain>& chains) {
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const auto& a = chains[i].corners;
    if (a.size() != 2) continue;
    const auto opposite = [&](const Chain& other) {
      return other.edge != chains[i].edge && other.corners.size() == 2 &&
             other.corners.front().vertex == a.back().vertex &&
             other.corners.back().vertex == a.front().vertex;
    };
    const auto found =
        std::find_if(chains.begin() + static_cast<std::ptrdiff_t>(i) + 1, chains.end(), opposite);
    if (found == chains.end()) continue;
    chains.erase(found);
    chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(i));
    --i;
  }
}

bool areOpposite(const Chain& one, const Chain& other) {
  return std::equal(
      one.corners.begin(), one.corners.end(), other.corners.rbegin(), other.corners.rend(),
      [](const BoundaryCorner& a, const BoundaryCorner& b) { return a.vertex == b.vertex; });
}

std::vector<std::pair<Chain, Chain>> cancelTouching(
    std::vector<Chain>& chains, const std::vector<std::size_t>& wire,
    const std::function<bool(const Chain&, const Chain&)>& runBack,
    const std::function<Point2(const SurfacePoint&)>& inPlane) {
  std::vector<std::pair<Chain, Chain>> pairs;
  std::vector<bool> isCancelled(chains.size(), false);
  for (std::size_t i = 0; i < chains.size(); ++i)
    for (std::size_t k = i + 1; k < chains.size() && !isCancelled[i]; ++k) {
      if (isCancelled[k] || chains[i].edge == chains[k].edge || !runBack(chains[i], chains[k]))
        continue;
      if (wire[i] == wire[k] && isSlit(chains, i, k, inPlane)) continue;
      isCancelled[i] = isCancelled[k] = true;
      pairs.emplace_back(chains[i], chains[k]);
    }
  std::size_t next = 0;
  std::erase_if(chains, [&](const Chain&) { return isCancelled[next++]; });
  return pairs;
}

std::vector<std::uint32_t> numberVertices(std::vector<Chain>& chains) {
  std::vector<std::uint32_t> known;  // points, sorted
  for (const Chain& chain : chains)
    for (const BoundaryCorner& corner : chain.corners) known.push_back(corner.vertex.value);
  std::ranges::sort(known);
  known.erase(std::ranges::unique(known).begin(), known.end());
  std::vector<VertexId> ids(known.size());
  std::vector<std::uint32_t> points;
  for (Chain& chain : chains)
    for (BoundaryCorner& corner : chain.corners) {
      const std::uint32_t point = corner.vertex.value;
      const auto place = std::ranges::lower_bound(known, point) - known.begin();
      VertexId& id = ids[static_cast<std::size_t>(place)];
      if (id.isNone()) {
        id = VertexId(points.size());
        points.push_back(point);
      }
      corner.vertex = id;
    }
  return points;
}

LinkedLoops linkChains(std::vector<Chain> chains) { return Linker(std::move(chains)).link(); }

}  // namespace af2::geometry
