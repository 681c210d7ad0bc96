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
