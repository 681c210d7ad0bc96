// Parts of a surface of triangles that are almost flat.
// Not installed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/faceted/half_edges.h"

namespace af2::geometry {

double lengthOf(const Facets& facets, HalfEdge h);
double areaOf(const Facets& facets, std::uint32_t triangle);
Point3 middleOf(const Facets& facets, std::uint32_t triangle);

/// Visits triangles from a start across edges: from a triangle to its neighbours, and further from
/// each neighbour for which `claim` returns true. `claim` must return true at most once for each
/// triangle.
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

/// Smooths the borders between labels. Triangles have labels, and a border is an edge where the
/// labels of neighbours differ. To straighten zigzag borders, each triangle repeatedly takes the
/// label of a neighbour if that clearly shortens the borders around it.
///
/// isBorder  (half-edge): whether a border runs there, by the labels as they are
/// mayTake   (triangle, label): whether the triangle may have that label
template <class IsBorder, class MayTake>
void straightenBorders(const Facets& facets, const std::vector<HalfEdge>& twins,
                       std::vector<std::uint32_t>& labels, const IsBorder& isBorder,
                       const MayTake& mayTake) {
  constexpr int kMaxRounds = 20;
  constexpr double kClearly = 0.999;  // so that rounding cannot make labels alternate for ever
  const auto bordersAround = [&](std::uint32_t t) {
    double sum = 0;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
      if (isBorder(h)) sum += lengthOf(facets, h);
    return sum;
  };
  bool isAny = true;
  for (int round = 0; isAny && round < kMaxRounds; ++round) {
    isAny = false;
    for (std::uint32_t t = 0; t < labels.size(); ++t) {
      const std::uint32_t before = labels[t];
      std::uint32_t best = before;
      double least = kClearly * bordersAround(t);
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        if (twins[h] == kNoHalfEdge || !mayTake(t, labels[twins[h] / 3])) continue;
        labels[t] = labels[twins[h] / 3];
        const double length = bordersAround(t);
        if (length < least) best = labels[t];
        least = std::min(least, length);
      }
      labels[t] = best;
      isAny = isAny || best != before;
    }
  }
}

/// Connected triangles with about the same normal.
struct Flat {
  Point3 normal, middle;
  double area = 0, perimeter = 0;
  /// The width of a strip; for a square half of its side.
  double width() const { return perimeter > 0 ? 2 * area / perimeter : 0; }
};

struct Flats {
  std::vector<Flat> flats;
  std::vector<std::uint32_t> of;  ///< by triangle
};

/// Regions grown from the largest triangles to the smallest, as long as normals differ by at most
/// three degrees.
///
/// twins    by half-edge: the opposite one, or kNoHalfEdge where nothing grows across
/// normals  by triangle, unit vectors; 0: unknown
Flats findFlats(const Facets& facets, const std::vector<HalfEdge>& twins,
                const std::vector<Point3>& normals);

}  // namespace af2::geometry
