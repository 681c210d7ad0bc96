// Joins feature edges to curves.
// Not installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "geometry/faceted/facets.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Curves of feature edges between corners. Corners are where a curve turns by more than an angle,
/// and where several curves meet.
class FeatureCurves {
 public:
  /// Where an edge is: between two vertices of a curve, that at `index`, which is `from`, and the
  /// next one.
  struct Place {
    std::size_t curve = 0, index = 0;
    std::uint32_t from = 0;
  };

  /// angle    in radians
  /// speckAt  by vertex: a turn that is reversed within this length is no corner
  FeatureCurves(const std::vector<Point3>& vertices, const std::set<FacetEdge>& edges, double angle,
                const std::vector<double>& speckAt);

  const std::vector<FeatureCurve>& curves() const { return curves_; }
  const Place& placeOf(const FacetEdge& edge) const { return places_.at(edge); }

 private:
  const Point3& at(std::uint32_t v) const { return vertices_[v]; }
  bool isCorner(std::uint32_t v) const;
  std::uint32_t beyondSpeck(std::uint32_t from, std::uint32_t next) const;
  void follow(std::uint32_t from, std::uint32_t to);

  const std::vector<Point3>& vertices_;
  double angle_;
  const std::vector<double>& speckAt_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> beside_;  // by vertex
  std::map<FacetEdge, Place> places_;
  std::vector<FeatureCurve> curves_;
};

}  // namespace af2::geometry
