// Parts of a surface of triangles that are all but flat.
// Not installed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/faceted/half_edges.h"

namespace af2::geometry {

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

/// Triangles have labels, and borders run where those of neighbours differ. Borders that run to and
/// fro between the triangles become shorter: again and again each triangle takes the label of a
/// neighbour if the borders around it are clearly shorter then.
///
/// isBorder  (half-edge): whether a border runs there, by the labels as they are
/// mayTake   (triangle, label): whether the triangle may have that label
template <class IsBorder, class MayTake>
void straightenBorders(const Facets& facets, const std::vector<HalfEdge>& twins,
                       std::vector<std::uint32_t>& labels, const IsBorder& isBorder,
                       const MayTake& mayTake) {
  constexpr int kMostRounds = 20;
  constexpr double kClearly = 0.999;  // so that rounding does not make labels go in circles
  const auto bordersAround = [&](std::uint32_t t) {
    double sum = 0;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
      if (isBorder(h)) sum += lengthOf(facets, h);
    return sum;
  };
  bool isAny = true;
  for (int round = 0; isAny && round < kMostRounds; ++round) {
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
