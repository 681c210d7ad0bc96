// Parts of a surface of triangles that are all but flat.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// Half-edges: 3 t + i runs from corner i of triangle t to the next one.
using HalfEdge = std::uint32_t;
constexpr HalfEdge kNoHalfEdge = 0xffffffffu;

inline HalfEdge nextIn(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
double angleBetween(const Point3& p, const Point3& q);
double lengthOf(const Facets& facets, HalfEdge h);
double areaOf(const Facets& facets, std::uint32_t triangle);
Point3 middleOf(const Facets& facets, std::uint32_t triangle);

/// Goes from a triangle to those across its edges, and from each to which `claim` says yes on to
/// the next ones. `claim` must say yes once at most for each triangle.
template <class Claim>
void flood(const std::vector<HalfEdge>& twins, std::uint32_t start, const Claim& claim) {
  std::vector<std::uint32_t> open{start};
  while (!open.empty()) {
    const std::uint32_t t = open.back();
    open.pop_back();
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
      if (twins[h] != kNoHalfEdge && claim(twins[h] / 3)) open.push_back(twins[h] / 3);
  }
}

/// Triangles that hang together, with about the same normal.
struct Flat {
  Point3 normal, middle;
  double area = 0, perimeter = 0;
  /// Of a strip; half of the side of a square.
  double width() const { return perimeter > 0 ? 2 * area / perimeter : 0; }
};

struct Flats {
  std::vector<Flat> flats;
  std::vector<std::uint32_t> of;  ///< by triangle
};

/// Grown from the largest triangles to the smallest, as far as normals differ by three degrees.
///
/// twins    by half-edge: the one across, or kNoHalfEdge where nothing grows across
/// normals  by triangle, units; 0: there is nothing to tell it by
Flats findFlats(const Facets& facets, const std::vector<HalfEdge>& twins,
                const std::vector<Point3>& normals);

}  // namespace af2::geometry
