// Finds triangles of a surface that cross each other, once somebody asks.
// Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <vector>

#include "geometry/faceted/facets.h"

namespace af2::geometry {

struct FacetsCross {
  std::array<std::uint32_t, 2> triangles{};
  Point3 place;
};

class CrossedFacets {
 public:
  /// All pairs that penetrate each other or overlap. Several threads may ask at once.
  ///
  /// facets  the same ones each time
  const std::vector<FacetsCross>& of(const Facets& facets);

 private:
  std::once_flag isKnown_;
  std::vector<FacetsCross> crossings_;
};

}  // namespace af2::geometry
