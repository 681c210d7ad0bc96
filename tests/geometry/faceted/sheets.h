// Surfaces of triangles made as grids, for tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/faceted/patches.h"

namespace af2::testing {

enum class Closed { InNeither, InFirst, InBoth };

/// Two triangles for each of n times m cells; the point in row i and column j is position(i, j).
/// Where the grid is closed, its last cells end at its first points.
template <class Position>
geometry::Facets grid(std::uint32_t n, std::uint32_t m, Closed closed, Position position) {
  geometry::Facets facets;
  const std::uint32_t rows = closed == Closed::InNeither ? n + 1 : n;
  const std::uint32_t columns = closed == Closed::InBoth ? m : m + 1;
  for (std::uint32_t i = 0; i < rows; ++i)
    for (std::uint32_t j = 0; j < columns; ++j) facets.vertices.push_back(position(i, j));
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return i % rows * columns + j % columns;
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      facets.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      facets.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return facets;
}

/// Edges are features from 40 degrees on, where elements are to be so long.
inline geometry::FeatureLimits limitsFor(double size) {
  constexpr double kDegree = std::numbers::pi / 180;
  return {40 * kDegree, 0.5 * size, 0.05 * size, [=](const Point3&) { return size; }};
}

}  // namespace af2::testing
