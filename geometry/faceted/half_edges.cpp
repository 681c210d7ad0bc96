#include "geometry/faceted/half_edges.h"

#include <algorithm>
#include <compare>
#include <utility>

namespace af2::geometry {

/// Sorted by their first vertices by counting, since each vertex has few edges.
HalfEdges::HalfEdges(const FacetTriangles& triangles) {
  std::vector<std::uint32_t> end;  // by vertex: of those whose first vertex it is, in the order
  for (const auto& corners : triangles) {
    const std::uint32_t last = std::max({corners[0], corners[1], corners[2]});
    if (last >= end.size()) end.resize(last + 1, 0);
    for (std::size_t i = 0; i < 3; ++i) ++end[std::min(corners[i], corners[(i + 1) % 3])];
  }
  std::uint32_t before = 0;
  for (std::uint32_t& count : end) before += std::exchange(count, before);
  struct Side {
    std::uint32_t other;
    HalfEdge half;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides(before);
  for (HalfEdge h = 0; h < before; ++h) {
    const auto [first, other] = edgeOf(triangles, h);
    sides[end[first]++] = {other, h};
  }
  halves_.reserve(sides.size());
  std::uint32_t begin = 0;
  for (std::uint32_t v = 0; v < end.size(); begin = end[v++]) {
    std::sort(sides.begin() + begin, sides.begin() + end[v]);
    for (std::uint32_t i = begin; i < end[v]; ++i) {
      if (i == begin || sides[i].other != sides[i - 1].other) {
        edges_.emplace_back(v, sides[i].other);
        first_.push_back(halves_.size());
      }
      halves_.push_back(sides[i].half);
    }
  }
  first_.push_back(halves_.size());
}

std::vector<HalfEdge> HalfEdges::twins() const {
  std::vector<HalfEdge> twins(halves_.size(), kNoHalfEdge);
  forEachEdge([&](const FacetEdge&, std::span<const HalfEdge> halves) {
    if (halves.size() != 2) return;
    twins[halves[0]] = halves[1];
    twins[halves[1]] = halves[0];
  });
  return twins;
}

std::vector<HalfEdge> HalfEdges::boundary() const {
  std::vector<HalfEdge> boundary;
  forEachEdge([&](const FacetEdge&, std::span<const HalfEdge> halves) {
    if (halves.size() == 1) boundary.push_back(halves[0]);
  });
  return boundary;
}

std::vector<HalfEdge> orientedTwins(const FacetTriangles& triangles) {
  std::vector<HalfEdge> twins = HalfEdges(triangles).twins();
  for (HalfEdge h = 0; h < twins.size(); ++h) {
    const HalfEdge twin = twins[h];
    if (twin != kNoHalfEdge && startOf(triangles, h) == startOf(triangles, twin))
      twins[h] = twins[twin] = kNoHalfEdge;
  }
  return twins;
}

}  // namespace af2::geometry
