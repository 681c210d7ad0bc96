#include "geometry/faceted/half_edges.h"

#include <algorithm>

namespace af2::geometry {

HalfEdges::HalfEdges(const FacetTriangles& triangles) {
  std::vector<std::pair<FacetEdge, HalfEdge>> all;
  all.reserve(3 * triangles.size());
  for (HalfEdge h = 0; h < 3 * triangles.size(); ++h) all.emplace_back(edgeOf(triangles, h), h);
  std::ranges::sort(all);
  halves_.reserve(all.size());
  for (const auto& [edge, h] : all) {
    if (edges_.empty() || edges_.back() != edge) {
      edges_.push_back(edge);
      first_.push_back(halves_.size());
    }
    halves_.push_back(h);
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
