#include "geometry/faceted/patches.h"

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "geometry/faceted/directions.h"
#include "geometry/faceted/feature_curves.h"
#include "geometry/faceted/feature_edges.h"
#include "geometry/faceted/plane_cut.h"

namespace af2::geometry {
namespace {

/// Triangles of each patch that has too little boundary to start from, e.g. none. A flat patch has
/// at least the perimeter of a disc of its area.
std::vector<std::vector<std::uint32_t>> bulgingPatches(const FeatureEdges& features) {
  constexpr double kShareOfDisc = 0.5;
  const std::vector<FeatureEdges::Extent> extents = features.extentsOfPatches();
  const auto isBulging = [&](std::size_t p) {
    return extents[p].perimeter < kShareOfDisc * std::sqrt(4 * std::numbers::pi * extents[p].area);
  };
  std::vector<std::vector<std::uint32_t>> triangles(features.patchCount());
  for (std::uint32_t t = 0; t < features.patchOf().size(); ++t)
    if (isBulging(features.patchOf()[t])) triangles[features.patchOf()[t]].push_back(t);
  std::erase_if(triangles, [](const auto& patch) { return patch.empty(); });
  return triangles;
}

std::vector<Patch> patchesOf(const Facets& facets, const FeatureEdges& features,
                             const FeatureCurves& curves) {
  std::vector<Patch> patches(features.patchCount());
  for (std::uint32_t t = 0; t < facets.triangles.size(); ++t)
    patches[features.patchOf()[t]].triangles.push_back(t);
  const std::vector<HalfEdge>& twins = features.twins();
  std::vector<bool> seen(twins.size(), false);
  for (HalfEdge first = 0; first < twins.size(); ++first) {
    if (twins[first] != kNoHalfEdge || seen[first]) continue;
    std::vector<CurveUse> loop;
    for (HalfEdge h = first; !seen[h]; h = nextAround(twins, h)) {
      seen[h] = true;
      const FeatureCurves::Place& place = curves.placeOf(edgeOf(facets.triangles, h));
      const bool reversed = startOf(facets.triangles, h) != place.from;
      const std::size_t start = reversed ? curves.curves()[place.curve].size() - 2 : 0;
      if (place.index == start) loop.push_back({place.curve, reversed});
    }
    patches[features.patchOf()[first / 3]].loops.push_back(std::move(loop));
  }
  return patches;
}

PatchedFacets patchesBetween(Facets facets, FacetDirections directions, const FeatureLimits& limits,
                             std::set<FacetEdge> cuts) {
  constexpr int kMaxRounds = 30;
  for (int round = 0;; ++round) {
    const FeatureEdges features(facets, directions, limits, cuts);
    const auto bulging = bulgingPatches(features);
    if (bulging.empty() || round == kMaxRounds) {
      const FeatureCurves curves = features.curves();
      std::vector<Patch> patches = patchesOf(facets, features, curves);
      return {std::move(facets), std::move(directions), features.normals(),
              curves.curves(),   std::move(patches),    std::move(cuts)};
    }
    for (const std::vector<std::uint32_t>& patch : bulging)
      cutAcross(facets, directions, patch, cuts);
  }
}

}  // namespace

PatchedFacets findPatches(Facets facets, const FeatureLimits& limits) {
  FacetDirections directions = directionsOf(facets, limits.sizeAt);
  return patchesBetween(std::move(facets), std::move(directions), limits, {});
}

PatchedFacets cutPatches(const PatchedFacets& patched, const std::set<FacetEdge>& cuts,
                         const FeatureLimits& limits) {
  std::set<FacetEdge> all = patched.cuts;
  all.insert(cuts.begin(), cuts.end());
  PatchedFacets cut = patchesBetween(patched.facets, patched.directions, limits, std::move(all));
  if (cut.facets.triangles == patched.facets.triangles) cut.crossed = patched.crossed;
  return cut;
}

}  // namespace af2::geometry
