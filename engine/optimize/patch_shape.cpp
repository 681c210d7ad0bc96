#include "engine/optimize/patch_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/base/eight_directions.h"
#include "engine/optimize/corner_cost.h"

namespace af2 {
namespace {

using Vertex = QuadPatch::Vertex;

constexpr double kTriangleScale = 1.1547005383792517;  // 2 / sqrt(3)

/// One corner of an element: between the vertices ahead and behind.
struct PatchCorner {
  Vertex at, ahead, behind;
  double scale;

  CornerShape shapeIn(const std::vector<Point2>& points) const {
    return {points[ahead] - points[at], points[behind] - points[at], scale};
  }
};

template <class Visit>
void forEachCorner(const QuadPatch& patch, std::size_t element, const Visit& visit) {
  const std::span<const Vertex> ring = patch.cornersAt(element);
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    visit(PatchCorner{ring[i], ring[(i + 1) % n], ring[(i + n - 1) % n],
                      n == 3 ? kTriangleScale : 1.0});
}

/// The corners that each inner vertex shapes, grouped by vertex.
class CornersByVertex {
 public:
  explicit CornersByVertex(const QuadPatch& patch) : first_(patch.vertexCount() + 2, 0) {
    const auto forEachPair = [&](const auto& visit) {
      // The corner opposite a vertex of a quadrilateral does not depend on it.
      for (std::size_t e = 0; e < patch.elementCount(); ++e) {
        if (!patch.isAlive(e)) continue;
        forEachCorner(patch, e, [&](const PatchCorner& corner) {
          for (const Vertex v : {corner.at, corner.ahead, corner.behind})
            if (patch.isInner(v)) visit(v, corner);
        });
      }
    };
    forEachPair([&](Vertex v, const PatchCorner&) { ++first_[v + 2u]; });
    for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
    corners_.resize(first_.back());
    forEachPair([&](Vertex v, const PatchCorner& c) { corners_[first_[v + 1u]++] = c; });
  }
  std::span<const PatchCorner> of(std::size_t v) const {
    return std::span(corners_).subspan(first_[v], first_[v + 1] - first_[v]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<PatchCorner> corners_;
};

class Smoother {
 public:
  Smoother(const QuadPatch& patch, std::vector<Point2>& points)
      : patch_(patch), points_(points), corners_(patch), isAwake_(patch.vertexCount(), false) {
    for (std::size_t v = 0; v < patch.vertexCount(); ++v)
      if (patch.isTouched(static_cast<Vertex>(v))) wakeAround(static_cast<Vertex>(v));
  }

  void run() {
    constexpr int kCentrings = 3, kSweeps = 6;
    for (int i = 0; i < kCentrings; ++i)
      forEachVertex([&](Vertex v) {
        if (patch_.isTouched(v)) points_[v] = meanOfNeighbors(v);
      });
    for (int i = 0; i < kSweeps; ++i) {
      bool isMoved = false;
      forEachVertex([&](Vertex v) { isMoved |= visit(v); });
      if (!isMoved) return;
    }
  }

 private:
  template <class Visit>
  void forEachVertex(const Visit& visit) {
    for (std::size_t v = 0; v < patch_.vertexCount(); ++v)
      if (!corners_.of(v).empty()) visit(static_cast<Vertex>(v));
  }

  Point2 meanOfNeighbors(Vertex v) const {
    Point2 sum;
    double count = 0;
    for (const PatchCorner& c : corners_.of(v))
      if (c.at == v) {
        sum = sum + points_[c.ahead] + points_[c.behind];
        count += 2;
      }
    return (1 / count) * sum;
  }

  double costAt(Vertex v) const {
    double sum = 0;
    for (const PatchCorner& c : corners_.of(v)) sum += c.shapeIn(points_).cost();
    return sum;
  }

  bool takeIfBetter(Vertex v, Point2 place, double& cost) {
    const Point2 before = points_[v];
    points_[v] = place;
    const double there = costAt(v);
    if (there < kEnough * cost) {
      cost = there;
      return true;
    }
    points_[v] = before;
    return false;
  }

  double reachOf(Vertex v) const {
    double reach = 0;
    for (const PatchCorner& c : corners_.of(v))
      if (c.at == v) reach = std::max(reach, length(points_[c.ahead] - points_[v]));
    return reach;
  }

  /// Improves a vertex unless it and its surroundings hardly moved since its last turn.
  bool visit(Vertex v) {
    if (!isAwake_[v]) return false;
    isAwake_[v] = false;
    const Point2 before = points_[v];
    const double reach = reachOf(v);
    if (!(isSoundAt(v) ? stepDown(v, reach) : searchAround(v, reach))) return false;
    if (distance(before, points_[v]) < kWakingMove * reach) return false;
    wakeAround(v);
    return true;
  }

  void wakeAround(Vertex v) {
    for (const PatchCorner& c : corners_.of(v))
      for (const Vertex near : {c.at, c.ahead, c.behind}) isAwake_[near] = true;
  }

  bool isSoundAt(Vertex v) const {
    return std::ranges::all_of(corners_.of(v),
                               [&](const PatchCorner& c) { return c.shapeIn(points_).isSound(); });
  }

  /// One step of Newton's method, shortened until it lowers the cost.
  bool stepDown(Vertex v, double reach) {
    constexpr int kHalvings = 4;
    constexpr double kLongest = 0.5;
    CornerSum sum;
    for (const PatchCorner& c : corners_.of(v)) {
      const double byAhead = c.at == v ? -1 : c.ahead == v ? 1 : 0;
      const double byBehind = c.at == v ? -1 : c.behind == v ? 1 : 0;
      c.shapeIn(points_).addTo(sum, byAhead, byBehind);
    }
    const double det = sum.xx * sum.yy - sum.xy * sum.xy;
    Point2 step;
    if (sum.xx > 0 && det > 0) {
      step = {-(sum.yy * sum.slope.x - sum.xy * sum.slope.y) / det,
              -(sum.xx * sum.slope.y - sum.xy * sum.slope.x) / det};
    } else if (const double slope = length(sum.slope); slope > 0) {
      step = (-kLongest * reach / slope) * sum.slope;
    }
    if (const double size = length(step); size > kLongest * reach)
      step = (kLongest * reach / size) * step;
    const Point2 before = points_[v];
    double cost = sum.value;
    for (int i = 0; i <= kHalvings; ++i, step = 0.5 * step)
      if (takeIfBetter(v, before + step, cost)) return true;
    return false;
  }

  /// For elements that are inverted or flat: the mean of the neighbours, then eight directions.
  bool searchAround(Vertex v, double reach) {
    constexpr int kHalvings = 4;
    constexpr double kFirst = 0.2;
    double cost = costAt(v), step = kFirst * reach;
    bool isMoved = takeIfBetter(v, meanOfNeighbors(v), cost);
    for (int i = 0; i < kHalvings; ++i) {
      bool isBetter = false;
      for (const Point2& direction : kEightDirections)
        isBetter |= takeIfBetter(v, points_[v] + step * direction, cost);
      isMoved |= isBetter;
      if (!isBetter) step *= 0.5;
    }
    return isMoved;
  }

  static constexpr double kEnough = 1 - 1e-6;
  /// Smaller moves, as a fraction of the longest side, do not wake the neighbours.
  static constexpr double kWakingMove = 2e-3;
  const QuadPatch& patch_;
  std::vector<Point2>& points_;
  CornersByVertex corners_;
  std::vector<std::uint8_t> isAwake_;  ///< by vertex
};

}  // namespace

double jacobianOf(const QuadPatch& patch, std::size_t element, const std::vector<Point2>& points) {
  double least = 1;
  forEachCorner(patch, element, [&](const PatchCorner& c) {
    const CornerShape shape = c.shapeIn(points);
    // Nothing can give a tip a better corner.
    if (!patch.isTip(c.at) || !(shape.area() > 0)) least = std::min(least, shape.scaledJacobian());
  });
  return least;
}

PatchJacobians jacobiansOf(const QuadPatch& patch, const std::vector<Point2>& points) {
  double least = 1, sum = 0, elements = 0;
  std::size_t turned = 0;
  for (std::size_t e = 0; e < patch.elementCount(); ++e) {
    if (!patch.isAlive(e)) continue;
    const double here = jacobianOf(patch, e, points);
    least = std::min(least, here);
    turned += here < kSoundJacobian ? 1 : 0;
    sum += here;
    elements += 1;
  }
  return {least, sum / elements, turned};
}

void smoothPatch(const QuadPatch& patch, std::vector<Point2>& points) {
  Smoother(patch, points).run();
}

}  // namespace af2
