// Finds the edges of triangles at which a surface turns, without those that noise makes.
// Not installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "geometry/faceted/feature_curves.h"
#include "geometry/faceted/half_edges.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// The feature edges of a surface of triangles (findPatches), and the patches between them.
class FeatureEdges {
 public:
  struct Extent {
    double perimeter = 0, area = 0;
    double across = 0;  ///< the diagonal of the box around it
  };

  /// All arguments must outlive this.
  FeatureEdges(const Facets& facets, const FacetDirections& directions, const FeatureLimits& limits,
               const std::set<FacetEdge>& forced);

  /// By half-edge: the opposite one; kNoHalfEdge at feature edges.
  const std::vector<HalfEdge>& twins() const { return twin_; }
  /// By triangle: where it looks to, if small roundings are edges, and specks do not count.
  const std::vector<Point3>& normals() const { return normals_; }
  /// By triangle, in the order of their first triangles.
  const std::vector<std::size_t>& patchOf() const { return patchOf_; }
  std::size_t patchCount() const { return patchCount_; }
  std::vector<Extent> extentsOfPatches() const;
  FeatureCurves curves() const;

 private:
  FacetEdge edgeOf(HalfEdge h) const { return geometry::edgeOf(facets_.triangles, h); }
  const Point3& at(std::uint32_t v) const { return facets_.vertices[v]; }
  const Point3& startAt(HalfEdge h) const { return at(startOf(facets_.triangles, h)); }
  bool isForced(HalfEdge h) const;
  bool mayVanish(HalfEdge h) const { return twin_[h] == kNoHalfEdge && !isForced(h); }
  bool areOfOnePart(HalfEdge g, HalfEdge h) const;
  bool isFeature(HalfEdge g, HalfEdge h) const;
  void smooth(HalfEdge h);
  void findTwins();
  void findSpecks();
  void findPatchOf();
  bool dropShortCreases();
  bool dropSpecks();
  std::vector<bool> findOnOneSide() const;
  bool dropSlivers();
  std::vector<int> countAround() const;
  bool dropSpikes();
  template <class IsMerged>
  bool mergeWithOthers(const IsMerged& isMerged);
  void lookAcross(const std::vector<HalfEdge>& borders);

  const Facets& facets_;
  const FacetDirections& directions_;
  const FeatureLimits& limits_;
  const std::set<FacetEdge>& forced_;
  std::vector<HalfEdge> partner_;  // kNoHalfEdge at edges that have not two triangles
  std::vector<HalfEdge> twin_;     // the same, but kNoHalfEdge at feature edges
  std::vector<Point3> normals_;
  std::vector<double> speckAt_;  // by vertex: what is smaller cannot be seen
  std::vector<bool> isCrease_;   // amid a rounding
  std::vector<std::size_t> patchOf_;
  std::size_t patchCount_ = 0;
};

}  // namespace af2::geometry
