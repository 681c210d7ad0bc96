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
    const std::size_t count = facets_.triangles.size();
    for (const std::uint32_t t : triangles) cut(t);
    if (std::ranges::all_of(crossings_, [](const auto& c) { return c.second.uses == 2; })) return;
    for (std::uint32_t t = 0; t < count; ++t) divideSides(t);
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

  /// Where the plane crosses an edge, and how many triangles of the edge have been cut.
  struct Crossing {
    std::uint32_t vertex = 0;
    int uses = 0;
  };

  std::uint32_t crossingOf(std::uint32_t a, std::uint32_t b) {
    const FacetEdge edge = std::minmax(a, b);
    const auto next = static_cast<std::uint32_t>(facets_.vertices.size());
    const auto [found, isNew] = crossings_.try_emplace(edge, Crossing{next, 0});
    if (isNew) {
      const double t = height(edge.first) / (height(edge.first) - height(edge.second));
      const Point3 p = facets_.vertices[edge.first], q = facets_.vertices[edge.second];
      facets_.vertices.push_back(p + t * (q - p));
      // An edge that was cut before stays cut.
      if (cuts_.erase(edge) > 0)
        for (const std::uint32_t end : {a, b}) cuts_.insert(std::minmax(end, next));
    }
    ++found->second.uses;
    return found->second.vertex;
  }

  void add(std::uint32_t like, const std::array<std::uint32_t, 3>& corners) {
    facets_.triangles.push_back(corners);
    if (!facets_.group.empty()) facets_.group.push_back(facets_.group[like]);
    auto& [normals, isRough] = directions_;
    normals.push_back(normals[like]);
    isRough.push_back(isRough[like]);
  }

  /// Divides a triangle beside the cut ones where their common sides were divided.
  void divideSides(std::uint32_t t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto corners = facets_.triangles[t];
      const std::uint32_t a = corners[i], b = corners[(i + 1) % 3], c = corners[(i + 2) % 3];
      const auto found = crossings_.find(std::minmax(a, b));
      if (found == crossings_.end()) continue;
      const std::uint32_t p = found->second.vertex;
      facets_.triangles[t] = {a, p, c};
      const auto other = static_cast<std::uint32_t>(facets_.triangles.size());
      add(t, {p, b, c});
      divideSides(t);
      divideSides(other);
      return;
    }
  }

  void cut(std::uint32_t t) {
    auto c = facets_.triangles[t];
    const auto isAbove = [&](std::uint32_t v) { return height(v) > 0; };
    if (isAbove(c[0]) == isAbove(c[1]) && isAbove(c[1]) == isAbove(c[2])) return;
    // The corner that is alone on its side comes first.
    while (isAbove(c[1]) != isAbove(c[2])) std::rotate(c.begin(), c.begin() + 1, c.end());
    const std::uint32_t p = crossingOf(c[0], c[1]), q = crossingOf(c[0], c[2]);
    facets_.triangles[t] = {c[0], p, q};
    add(t, {p, c[1], c[2]});
    add(t, {p, c[2], q});
    cuts_.insert(std::minmax(p, q));
  }

  Facets& facets_;
  FacetDirections& directions_;
  std::set<FacetEdge>& cuts_;
  std::map<FacetEdge, Crossing> crossings_;
  Point3 axis_;
  double offset_ = 0;
};

}  // namespace

void cutAcross(Facets& facets, FacetDirections& directions,
               const std::vector<std::uint32_t>& triangles, std::set<FacetEdge>& cuts) {
  PlaneCut(facets, directions, triangles, cuts);
}

}  // namespace af2::geometry
