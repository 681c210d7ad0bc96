#include "engine/optimize/patch_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace af2 {
namespace {

using Vertex = QuadPatch::Vertex;

constexpr double kTriangleScale = 1.1547005383792517;  // 2 / sqrt(3)

std::size_t sizeOf(const QuadPatch::Ring& ring) { return ring[3] == QuadPatch::kNone ? 3 : 4; }

/// One corner of an element: between the vertices ahead and behind.
struct PatchCorner {
  Vertex at, ahead, behind;
  double scale;  ///< of its sine, so that the ideal corner has 1
};

double sineOf(const PatchCorner& c, const std::vector<Point2>& points) {
  const Point2 e = points[c.ahead] - points[c.at], f = points[c.behind] - points[c.at];
  const double product = std::sqrt(dot(e, e) * dot(f, f));
  return product > 0 ? c.scale * cross(e, f) / product : -1;
}

/// Grows steeply where a corner becomes flat, and further where it is inverted, so that a smaller
/// sum always means a mesh that is nearer to being sound. The second term wants sides of equal
/// length.
double costOf(const PatchCorner& c, const std::vector<Point2>& points) {
  constexpr double kFlat = 0.05, kShape = 0.25;
  const Point2 e = points[c.ahead] - points[c.at], f = points[c.behind] - points[c.at];
  const double ee = dot(e, e), ff = dot(f, f), product = std::sqrt(ee * ff);
  if (!(product > 0)) return 1e12;
  const double s = c.scale * cross(e, f) / product;
  const double steep = 1 / (kFlat * kFlat);
  const double turned = s >= kFlat ? 1 / (s * s) : steep + 2 * steep / kFlat * (kFlat - s);
  const double aspect = 0.5 * (ee + ff) / product;
  return turned + kShape * aspect * aspect;
}

class Smoother {
 public:
  Smoother(const QuadPatch& patch, std::vector<Point2>& points)
      : patch_(patch), points_(points), corners_(patch.vertexCount()) {
    for (std::size_t e = 0; e < patch.elementCount(); ++e) {
      if (!patch.isAlive(e)) continue;
      const QuadPatch::Ring& ring = patch.ringAt(e);
      const std::size_t n = sizeOf(ring);
      for (std::size_t i = 0; i < n; ++i) {
        const PatchCorner corner{ring[i], ring[(i + 1) % n], ring[(i + n - 1) % n],
                                 n == 3 ? kTriangleScale : 1.0};
        // The corner opposite a vertex of a quadrilateral does not depend on it.
        for (const Vertex v : {corner.at, corner.ahead, corner.behind})
          if (patch.isInner(v)) corners_[v].push_back(corner);
      }
    }
  }

  void run() {
    constexpr int kCentrings = 3, kSweeps = 6;
    for (int i = 0; i < kCentrings; ++i)
      forEachVertex([&](Vertex v) {
        if (patch_.isTouched(v)) points_[v] = meanOfNeighbors(v);
      });
    for (int i = 0; i < kSweeps; ++i) {
      bool isMoved = false;
      forEachVertex([&](Vertex v) { isMoved |= improve(v); });
      if (!isMoved) return;
    }
  }

 private:
  template <class Visit>
  void forEachVertex(const Visit& visit) {
    for (std::size_t v = 0; v < corners_.size(); ++v)
      if (!corners_[v].empty()) visit(static_cast<Vertex>(v));
  }

  Point2 meanOfNeighbors(Vertex v) const {
    Point2 sum;
    double count = 0;
    for (const PatchCorner& c : corners_[v])
      if (c.at == v) {
        sum = sum + points_[c.ahead] + points_[c.behind];
        count += 2;
      }
    return (1 / count) * sum;
  }

  double costAt(Vertex v) const {
    double sum = 0;
    for (const PatchCorner& c : corners_[v]) sum += costOf(c, points_);
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
    for (const PatchCorner& c : corners_[v])
      if (c.at == v) reach = std::max(reach, length(points_[c.ahead] - points_[v]));
    return reach;
  }

  bool improve(Vertex v) {
    constexpr int kHalvings = 4;
    constexpr double kFirst = 0.2, kDiagonal = 0.7071067811865476;
    constexpr std::array<Point2, 8> kDirections{{{1, 0},
                                                 {kDiagonal, kDiagonal},
                                                 {0, 1},
                                                 {-kDiagonal, kDiagonal},
                                                 {-1, 0},
                                                 {-kDiagonal, -kDiagonal},
                                                 {0, -1},
                                                 {kDiagonal, -kDiagonal}}};
    double cost = costAt(v), step = kFirst * reachOf(v);
    bool isMoved = takeIfBetter(v, meanOfNeighbors(v), cost);
    for (int i = 0; i < kHalvings; ++i) {
      bool isBetter = false;
      for (const Point2& direction : kDirections)
        isBetter |= takeIfBetter(v, points_[v] + step * direction, cost);
      isMoved |= isBetter;
      if (!isBetter) step *= 0.5;
    }
    return isMoved;
  }

  static constexpr double kEnough = 1 - 1e-6;
  const QuadPatch& patch_;
  std::vector<Point2>& points_;
  std::vector<std::vector<PatchCorner>> corners_;  ///< by inner vertex: those that it shapes
};

}  // namespace

double leastScaledJacobian(const QuadPatch& patch, const std::vector<Point2>& points) {
  double least = 1;
  for (std::size_t e = 0; e < patch.elementCount(); ++e) {
    if (!patch.isAlive(e)) continue;
    const QuadPatch::Ring& ring = patch.ringAt(e);
    const std::size_t n = sizeOf(ring);
    for (std::size_t i = 0; i < n; ++i)
      least = std::min(least, sineOf({ring[i], ring[(i + 1) % n], ring[(i + n - 1) % n],
                                      n == 3 ? kTriangleScale : 1.0},
                                     points));
  }
  return least;
}

void smoothPatch(const QuadPatch& patch, std::vector<Point2>& points) {
  Smoother(patch, points).run();
}

}  // namespace af2
