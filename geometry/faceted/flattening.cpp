#include "geometry/faceted/flattening.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/base/elementary.h"
#include "engine/base/predicates.h"
#include "geometry/faceted/half_edges.h"
#include "geometry/faceted/sparse_system.h"

namespace af2::geometry {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Loop = std::vector<std::uint32_t>;
constexpr std::uint32_t kNoCorner = 0xffffffffu;

class Flattening {
 public:
  Flattening(const std::vector<Point3>& vertices, const std::vector<Corners>& triangles)
      : vertices_(vertices), triangles_(triangles), given_(triangles.size()) {}

  std::optional<std::vector<Point2>> flatten() {
    if (!findLoops()) return std::nullopt;
    fillHoles();
    if (!isDisc()) return std::nullopt;
    drawCircle();
    if (!drawInside()) return std::nullopt;
    const auto isNumber = [](Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    if (!std::ranges::all_of(places_, isNumber)) return std::nullopt;
    for (std::size_t t = 0; t < given_; ++t) {
      const auto& [a, b, c] = triangles_[t];
      if (orientation(places_[a], places_[b], places_[c]) != Turn::Left) return std::nullopt;
    }
    places_.resize(vertices_.size() - holes_);
    return std::move(places_);
  }

 private:
  /// Whether each edge has two triangles, one on each side, or lies on a boundary that does not
  /// touch itself.
  bool findLoops() {
    std::vector<std::uint32_t> after(vertices_.size(), kNoCorner);
    edges_ = 0;
    bool isManifold = true;
    HalfEdges(triangles_).forEachEdge([&](const FacetEdge&, std::span<const HalfEdge> halves) {
      ++edges_;
      const std::uint32_t start = startOf(triangles_, halves[0]);
      if (halves.size() == 2 && startOf(triangles_, halves[1]) != start) return;
      isManifold = isManifold && halves.size() == 1 && after[start] == kNoCorner;
      after[start] = endOf(triangles_, halves[0]);
    });
    if (!isManifold) return false;
    for (std::uint32_t first = 0; first < after.size(); ++first) {
      if (after[first] == kNoCorner) continue;
      Loop& loop = loops_.emplace_back();
      for (std::uint32_t v = first; after[v] != kNoCorner;) {
        loop.push_back(v);
        v = std::exchange(after[v], kNoCorner);
      }
    }
    if (loops_.empty()) return false;
    std::ranges::iter_swap(loops_.begin(), std::ranges::max_element(loops_, {}, [&](const Loop& l) {
                             return lengthOf(l);
                           }));
    return true;
  }
  double lengthOf(const Loop& loop) const {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum += distance(vertices_[loop[i]], vertices_[loop[(i + 1) % loop.size()]]);
    return sum;
  }

  /// All boundaries but the longest, by triangles around a vertex in their middle.
  void fillHoles() {
    for (std::size_t k = 1; k < loops_.size(); ++k) {
      const auto middle = static_cast<std::uint32_t>(vertices_.size());
      const Loop& loop = loops_[k];
      Point3 sum;
      for (const std::uint32_t v : loop) sum = sum + vertices_[v];
      vertices_.push_back((1.0 / static_cast<double>(loop.size())) * sum);
      for (std::size_t i = 0; i < loop.size(); ++i)
        triangles_.push_back({loop[(i + 1) % loop.size()], loop[i], middle});
      edges_ += loop.size();
      ++holes_;
    }
  }
  /// Decided by Euler's number; the triangles are known to be connected.
  bool isDisc() const { return vertices_.size() + triangles_.size() == edges_ + 1; }

  void drawCircle() {
    double area = 0;
    for (const auto& [a, b, c] : triangles_)
      area += length(cross(vertices_[b] - vertices_[a], vertices_[c] - vertices_[a])) / 2;
    const double radius = std::sqrt(area / std::numbers::pi);
    const Loop& rim = loops_.front();
    const double whole = lengthOf(rim);
    isOnRim_.assign(vertices_.size(), false);
    places_.resize(vertices_.size());
    double way = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const double angle = 2 * std::numbers::pi * way / whole;
      places_[rim[i]] = radius * directionAt(angle);
      isOnRim_[rim[i]] = true;
      way += distance(vertices_[rim[i]], vertices_[rim[(i + 1) % rim.size()]]);
    }
  }

  /// Each vertex is a mean of those around it, by mean value weights. Whether there is a solution.
  bool drawInside() {
    std::vector<std::uint32_t> unknown(vertices_.size(), kNoCorner), inside;
    for (std::uint32_t v = 0; v < vertices_.size(); ++v)
      if (!isOnRim_[v]) {
        unknown[v] = static_cast<std::uint32_t>(inside.size());
        inside.push_back(v);
      }
    const double least = 1e-12 * lengthOf(loops_.front());  // vertices may coincide
    std::vector<SparseEntry> matrix;
    std::vector<Point2> right(inside.size());
    for (const Corners& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t row = unknown[t[i]];
        if (row == kNoCorner) continue;
        const std::array<std::uint32_t, 2> others{t[(i + 1) % 3], t[(i + 2) % 3]};
        const Point3 p = vertices_[others[0]] - vertices_[t[i]];
        const Point3 q = vertices_[others[1]] - vertices_[t[i]];
        for (const std::uint32_t v : others) {
          const double away = distance(vertices_[v], vertices_[t[i]]);
          const double weight = tangentOfHalf(p, q) / std::max(away, least);
          matrix.push_back({row, row, weight});
          if (unknown[v] != kNoCorner)
            matrix.push_back({row, unknown[v], -weight});
          else
            right[row] = right[row] + weight * places_[v];
        }
      }
    const auto solution = solveSparse(matrix, right);
    if (!solution) return false;
    for (std::size_t i = 0; i < inside.size(); ++i) places_[inside[i]] = (*solution)[i];
    return true;
  }
  /// Kept away from the ends, where triangles have no area.
  static double tangentOfHalf(const Point3& p, const Point3& q) {
    constexpr double kMin = 1e-3, kMax = 1e3;
    return std::clamp(tangent(angleBetween(p, q) / 2), kMin, kMax);
  }

  std::vector<Point3> vertices_;
  FacetTriangles triangles_;
  std::size_t given_, edges_ = 0;
  std::uint32_t holes_ = 0;
  std::vector<Loop> loops_;  // the longest first
  std::vector<bool> isOnRim_;
  std::vector<Point2> places_;
};

}  // namespace

std::optional<std::vector<Point2>> flatten(const std::vector<Point3>& vertices,
                                           const std::vector<Corners>& triangles) {
  return Flattening(vertices, triangles).flatten();
}

}  // namespace af2::geometry
