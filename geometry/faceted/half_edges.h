// The sides of triangles, and which of them coincide.
// Not installed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// A side of a triangle: 3 t + i runs from corner i of triangle t to the next corner.
using HalfEdge = std::uint32_t;
inline constexpr HalfEdge kNoHalfEdge = 0xffffffffu;

/// The sides after and before this one in its triangle.
inline HalfEdge nextIn(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline HalfEdge previousIn(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// The sides without a twin that come after and before this one around the triangles that hang
/// together through twins.
inline HalfEdge nextAround(const std::vector<HalfEdge>& twins, HalfEdge h) {
  HalfEdge next = nextIn(h);
  while (twins[next] != kNoHalfEdge) next = nextIn(twins[next]);
  return next;
}
inline HalfEdge previousAround(const std::vector<HalfEdge>& twins, HalfEdge h) {
  HalfEdge previous = previousIn(h);
  while (twins[previous] != kNoHalfEdge) previous = previousIn(twins[previous]);
  return previous;
}

inline std::uint32_t startOf(const FacetTriangles& triangles, HalfEdge h) {
  return triangles[h / 3][h % 3];
}
inline std::uint32_t endOf(const FacetTriangles& triangles, HalfEdge h) {
  return startOf(triangles, nextIn(h));
}
inline FacetEdge edgeOf(const FacetTriangles& triangles, HalfEdge h) {
  return std::minmax(startOf(triangles, h), endOf(triangles, h));
}

/// The half-edges of some triangles, grouped by edge.
///
/// The edges are in the order of their vertices, the half-edges of each in ascending order. An edge
/// is a boundary if it has one half-edge. If it has two, they are twins, whether they have opposite
/// directions, as they do where both triangles are oriented alike, or the same direction. If it has
/// more, several sheets of a surface meet there, and none of its half-edges has a twin.
class HalfEdges {
 public:
  explicit HalfEdges(const FacetTriangles& triangles);

  /// Calls visit(edge, half-edges) for each edge.
  template <class Visit>
  void forEachEdge(const Visit& visit) const {
    const std::span<const HalfEdge> all(halves_);
    for (std::size_t i = 0; i < edges_.size(); ++i)
      visit(edges_[i], all.subspan(first_[i], first_[i + 1] - first_[i]));
  }

  /// By half-edge: its twin, or kNoHalfEdge.
  std::vector<HalfEdge> twins() const;

  /// The half-edges that are alone at their edge.
  std::vector<HalfEdge> boundary() const;

 private:
  std::vector<FacetEdge> edges_;
  std::vector<std::size_t> first_;  // by edge, and at the end: in halves_
  std::vector<HalfEdge> halves_;
};

/// By half-edge: its twin in the other direction, or kNoHalfEdge. Twins in the same direction, as a
/// surface with one side has, are none.
std::vector<HalfEdge> orientedTwins(const FacetTriangles& triangles);

}  // namespace af2::geometry
