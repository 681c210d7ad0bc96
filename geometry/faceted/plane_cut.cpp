#include "geometry/faceted/plane_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "geometry/faceted/main_directions.h"

namespace af2::geometry {

namespace {

class PlaneCut {
 public:
  PlaneCut(Facets& facets, FacetDirections& directions, const std::vector<std::uint32_t>& triangles,
           std::set<FacetEdge>& cuts)
      : facets_(facets), directions_(directions), cuts_(cuts) {
    choosePlane(triangles);
    for (const std::uint32_t t : triangles) cut(t);
  }

 private:
  double height(std::uint32_t v) const { return dot(facets_.vertices[v], axis_) - offset_; }

  void choosePlane(const std::vector<std::uint32_t>& triangles) {
    chooseAxis(triangles);
    std::set<std::uint32_t> vertices;
    for (const std::uint32_t t : triangles)
      vertices.insert(facets_.triangles[t].begin(), facets_.triangles[t].end());
    std::set<double> heights;
    for (const std::uint32_t v : vertices) heights.insert(height(v));
    // In the widest gap of the middle third: vertices that nearly lie in the plane make slivers.
    const double low = *heights.begin(), extent = *heights.rbegin() - low;
    double widest = -1;
    for (auto above = std::next(heights.begin()); above != heights.end(); ++above) {
      const double below = *std::prev(above), middle = (below + *above) / 2;
      if (*above - below <= widest || std::abs(middle - low - extent / 2) > extent / 6) continue;
      widest = *above - below;
      offset_ = middle;
    }
    if (widest < 0) offset_ = low + extent / 2;  // no vertex near the middle
  }

  /// A long tube that were cut across would come to as many pieces as it is longer than wide.
  void chooseAxis(const std::vector<std::uint32_t>& triangles) {
    constexpr double kAlike = 3;  // the longest extent over the shortest
    const std::array<Point3, 3> axes = mainDirections(facets_, triangles);
    std::array<double, 3> extents{};
    for (std::size_t i = 0; i < 3; ++i) extents[i] = extentAlong(axes[i], triangles);
    const auto [least, most] = std::ranges::minmax_element(extents);
    const auto chosen = *most > kAlike * *least ? least : most;
    axis_ = axes[static_cast<std::size_t>(chosen - extents.begin())];
  }
  double extentAlong(const Point3& axis, const std::vector<std::uint32_t>& triangles) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::uint32_t t : triangles)
      for (const std::uint32_t v : facets_.triangles[t]) {
        const double along = dot(facets_.vertices[v], axis);
        low = std::min(low, along);
        high = std::max(high, along);
      }
    return high - low;
  }

  std::uint32_t crossingOf(std::uint32_t a, std::uint32_t b) {
    const FacetEdge edge = std::minmax(a, b);
    const auto [found, isNew] =
        crossings_.try_emplace(edge, static_cast<std::uint32_t>(facets_.vertices.size()));
    if (isNew) {
      const double t = height(edge.first) / (height(edge.first) - height(edge.second));
      const Point3 p = facets_.vertices[edge.first], q = facets_.vertices[edge.second];
      facets_.vertices.push_back(p + t * (q - p));
    }
    return found->second;
  }

  void cut(std::uint32_t t) {
    auto c = facets_.triangles[t];
    const auto isAbove = [&](std::uint32_t v) { return height(v) > 0; };
    if (isAbove(c[0]) == isAbove(c[1]) && isAbove(c[1]) == isAbove(c[2])) return;
    // The corner that is alone on its side comes first.
    while (isAbove(c[1]) != isAbove(c[2])) std::rotate(c.begin(), c.begin() + 1, c.end());
    const std::uint32_t p = crossingOf(c[0], c[1]), q = crossingOf(c[0], c[2]);
    facets_.triangles[t] = {c[0], p, q};
    facets_.triangles.push_back({p, c[1], c[2]});
    facets_.triangles.push_back({p, c[2], q});
    if (!facets_.group.empty()) facets_.group.insert(facets_.group.end(), 2, facets_.group[t]);
    auto& [normals, isRough] = directions_;
    normals.insert(normals.end(), 2, normals[t]);
    isRough.insert(isRough.end(), 2, isRough[t]);
    cuts_.insert(std::minmax(p, q));
  }

  Facets& facets_;
  FacetDirections& directions_;
  std::set<FacetEdge>& cuts_;
  std::map<FacetEdge, std::uint32_t> crossings_;
  Point3 axis_;
  double offset_ = 0;
};

}  // namespace

void cutAcross(Facets& facets, FacetDirections& directions,
               const std::vector<std::uint32_t>& triangles, std::set<FacetEdge>& cuts) {
  PlaneCut(facets, directions, triangles, cuts);
}

}  // namespace af2::geometry
