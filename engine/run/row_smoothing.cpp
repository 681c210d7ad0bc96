#include "engine/run/row_smoothing.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/segment.h"

namespace af2 {
namespace {

constexpr double kGoodJacobian = 0.5;
constexpr double kStep = 0.5, kAlong = 0.35;
/// In wanted lengths: the longest move, the shortest one that is worth its cost, and how near the
/// front may come to itself.
constexpr double kLongestMove = 0.25, kShortestMove = 1e-3, kNearest = 0.3;

class RowSmoother {
 public:
  explicit RowSmoother(Advance& advance) : advance_(advance) { collect(); }

  std::size_t round() {
    ++round_;
    std::size_t moves = 0;
    for (const auto& [vertex, place] : onFront_) moves += visit(vertex, place, true);
    for (const auto& [vertex, place] : behind_) moves += visit(vertex, place, false);
    return moves;
  }

 private:
  /// Only where something has moved since the last visit is there anything to do.
  bool visit(VertexId v, PlaceId place, bool isOnFront) {
    if (stirred_[v.value] < round_ - 1 || !smooth(v, place, isOnFront)) return false;
    stirred_[v.value] = round_;
    advance_.elements.forEachAt(v, [&](std::size_t e, std::size_t) {
      for (const VertexId w : advance_.mesh.elements[e].vertices()) stirred_[w.value] = round_;
    });
    return true;
  }

  using Vertices = std::vector<std::pair<VertexId, PlaceId>>;

  /// The vertices of the front, and those behind it with a place of the front to see them from.
  void collect() {
    Vertices all;
    const Front& front = advance_.front;
    for (std::size_t i = 0; i < front.capacity(); ++i)
      if (front.hasEdge(PlaceId(i))) all.emplace_back(front[PlaceId(i)].vertex, PlaceId(i));
    std::ranges::sort(all);
    isOnFront_.assign(advance_.mesh.vertices.size(), false);
    stirred_.assign(advance_.mesh.vertices.size(), 0);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool isAlone = (i == 0 || all[i - 1].first != all[i].first) &&
                           (i + 1 == all.size() || all[i + 1].first != all[i].first);
      isOnFront_[all[i].first.value] = true;
      if (isAlone && !advance_.isFixed(all[i].first) && !isInTriangle(all[i].second))
        onFront_.push_back(all[i]);
    }
    for (const auto& [vertex, place] : onFront_)
      advance_.elements.forEachAt(vertex, [&](std::size_t e, std::size_t) {
        for (const VertexId v : advance_.mesh.elements[e].vertices())
          if (!isOnFront_[v.value] && !advance_.isFixed(v)) behind_.emplace_back(v, place);
      });
    std::ranges::sort(behind_);
    const auto same = [](const auto& p, const auto& q) { return p.first == q.first; };
    behind_.erase(std::unique(behind_.begin(), behind_.end(), same), behind_.end());
  }

  /// All edges of such a loop are neighbours, so nothing would keep one of its vertices from
  /// passing over the opposite edge.
  bool isInTriangle(PlaceId place) const {
    const Front& front = advance_.front;
    return front.next(front.next(front.next(place))) == place;
  }

  bool smooth(VertexId v, PlaceId place, bool isOnFront) {
    try {
      const StepChart chart = advance_.chartAt(place, slot_);
      const Point2 from = chart.positionOf(advance_.mesh.vertices[v.value]);
      auto to = isOnFront ? wantedOnFront(chart, v, place, from) : wantedBehind(chart, v, from);
      if (!to) return false;
      const double away = distance(from, *to);
      if (away < kShortestMove) return false;
      if (away > kLongestMove) to = from + (kLongestMove / away) * (*to - from);
      if (!keepsElements(chart, v, from, *to)) return false;
      if (isOnFront && !keepsApart(chart, v, place, *to)) return false;
      const auto lifted = chart.lift(*to);
      if (!lifted) return false;
      if (isOnFront) {
        advance_.move(v, {&place, 1}, *lifted);
      } else {
        advance_.mesh.vertices[v.value] = *lifted;
      }
      return true;
    } catch (const GeometryError&) {
      return false;
    }
  }

  Point2 at(const StepChart& chart, VertexId v) const {
    return chart.positionOf(advance_.mesh.vertices[v.value]);
  }

  /// Where the quadrilaterals at the vertex would be parallelograms, in the mean.
  std::optional<Point2> parallelograms(const StepChart& chart, VertexId v) const {
    Point2 sum;
    int count = 0;
    advance_.elements.forEachAt(v, [&](std::size_t e, std::size_t c) {
      const Element& element = advance_.mesh.elements[e];
      if (!element.isQuad()) return;
      sum = sum + at(chart, element.corners[(c + 1) % 4]) +
            at(chart, element.corners[(c + 3) % 4]) - at(chart, element.corners[(c + 2) % 4]);
      ++count;
    });
    if (count == 0) return std::nullopt;
    return (1.0 / count) * sum;
  }

  std::optional<Point2> wantedOnFront(const StepChart& chart, VertexId v, PlaceId place,
                                      Point2 from) const {
    const auto ideal = parallelograms(chart, v);
    if (!ideal) return std::nullopt;
    const Front& front = advance_.front;
    const Point2 before = chart.positionOf(front[front.previous(place)].point);
    const Point2 after = chart.positionOf(front[front.next(place)].point);
    const Point2 along = after - before;
    const double squared = dot(along, along);
    const Point2 middle = 0.5 * (before + after) - from;
    const Point2 evened = squared > 0 ? (dot(middle, along) / squared) * along : Point2{};
    return from + kStep * (*ideal - from) + kAlong * evened;
  }

  /// Half way to the mean of its neighbours.
  std::optional<Point2> wantedBehind(const StepChart& chart, VertexId v, Point2 from) const {
    Point2 sum;
    int count = 0;
    advance_.elements.forEachAt(v, [&](std::size_t e, std::size_t c) {
      const Element& element = advance_.mesh.elements[e];
      const auto n = static_cast<std::size_t>(element.size());
      sum = sum + at(chart, element.corners[(c + 1) % n]) +
            at(chart, element.corners[(c + n - 1) % n]);
      count += 2;
    });
    if (count == 0) return std::nullopt;
    return from + kStep * ((1.0 / count) * sum - from);
  }

  bool keepsElements(const StepChart& chart, VertexId v, Point2 from, Point2 to) const {
    const auto least = [&](Point2 place) {
      double jacobian = 1;
      advance_.elements.forEachAt(v, [&](std::size_t e, std::size_t) {
        const Element& element = advance_.mesh.elements[e];
        jacobian = std::min(jacobian, scaledJacobianIn(chart, advance_.mesh, element, v, place));
      });
      return jacobian;
    };
    const double after = least(to);
    return after >= kGoodJacobian || after >= least(from);
  }

  /// Whether the front edges at a place would stay away from all others but their neighbours.
  bool keepsApart(const StepChart& chart, VertexId v, PlaceId place, Point2 to) const {
    const Front& front = advance_.front;
    const std::array ends{front.previous(place), front.next(place)};
    const double reach = (kLongestMove + kNearest) * chart.unit();
    const double longest = std::max(front.edgeLength(place), front.edgeLength(ends[0]));
    for (const PlaceId edge : advance_.edgesNear(place, reach + longest)) {
      const VertexId start = front[edge].vertex;
      const VertexId end = front.hasEdge(edge) ? front[front.next(edge)].vertex : start;
      if (start == v || end == v) continue;
      const Point2 p = at(chart, start), q = at(chart, end);
      for (const PlaceId other : ends) {
        const VertexId w = front[other].vertex;
        if (start == w || end == w) continue;
        if (areCloser(kNearest, to, at(chart, w), p, q)) return false;
      }
    }
    return true;
  }

  Advance& advance_;
  ChartSlot slot_;
  Vertices onFront_, behind_;
  std::vector<bool> isOnFront_;  ///< by vertex
  int round_ = 0;
  std::vector<int> stirred_;  ///< by vertex: the last round in which it or a neighbour moved
};

}  // namespace

std::size_t smoothRow(Advance& advance, int rounds) {
  RowSmoother smoother(advance);
  std::size_t moves = 0;
  for (int round = 0; round < rounds; ++round) moves += smoother.round();
  return moves;
}

}  // namespace af2
