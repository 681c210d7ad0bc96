#include "geometry/faceted/feature_edges.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "engine/base/elementary.h"
#include "geometry/base/box_tree.h"
#include "geometry/base/constants.h"
#include "geometry/faceted/blends.h"
#include "geometry/faceted/directions.h"
#include "geometry/faceted/flats.h"

namespace af2::geometry {
namespace {

constexpr double kFold = 0.2;  // of a speck: triangulations of smooth surfaces have folds so wide

}  // namespace

FeatureEdges::FeatureEdges(const Facets& facets, const FacetDirections& directions,
                           const FeatureLimits& limits, const std::set<FacetEdge>& forced)
    : facets_(facets),
      directions_(directions),
      limits_(limits),
      forced_(forced),
      normals_(directions.normals) {
  findTwins();
  findPatchOf();
  while (dropShortCreases()) {
  }
  while (dropSpecks()) findPatchOf();
  while (dropSlivers()) findPatchOf();
  while (dropSpikes()) {
  }
  while (dropShortCreases()) {  // what was between two of these
  }
  findPatchOf();
}

std::vector<FeatureEdges::Extent> FeatureEdges::extentsOfPatches() const {
  std::vector<Extent> extents(patchCount_);
  std::vector<Box3> boxes(patchCount_);
  for (HalfEdge h = 0; h < twin_.size(); ++h)
    if (twin_[h] == kNoHalfEdge) extents[patchOf_[h / 3]].perimeter += lengthOf(facets_, h);
  for (std::uint32_t t = 0; t < patchOf_.size(); ++t) {
    extents[patchOf_[t]].area += areaOf(facets_, t);
    for (const std::uint32_t v : facets_.triangles[t]) boxes[patchOf_[t]].add(at(v));
  }
  for (std::size_t p = 0; p < patchCount_; ++p)
    extents[p].across = distance(boxes[p].low, boxes[p].high);
  return extents;
}

FeatureCurves FeatureEdges::curves() const {
  std::set<FacetEdge> edges;
  for (HalfEdge h = 0; h < twin_.size(); ++h)
    if (twin_[h] == kNoHalfEdge) edges.insert(edgeOf(h));
  return FeatureCurves(facets_.vertices, edges, limits_.angle, speckAt_);
}

void FeatureEdges::findTwins() {
  twin_ = partner_ = orientedTwins(facets_.triangles);
  findSpecks();
  std::vector<bool> isFeatureEdge(twin_.size(), false);
  for (HalfEdge h = 0; h < twin_.size(); ++h)
    isFeatureEdge[h] = twin_[h] != kNoHalfEdge && isFeature(h, twin_[h]);
  for (HalfEdge h = 0; h < twin_.size(); ++h)
    if (isFeatureEdge[h]) twin_[h] = kNoHalfEdge;
  SharpBlends sharp =
      sharpenBlends(facets_, twin_, std::move(normals_), {limits_.angle, limits_.sizeAt});
  normals_ = std::move(sharp.normals);
  isCrease_ = std::move(sharp.isCrease);
  for (HalfEdge h = 0; h < twin_.size(); ++h)
    if (isCrease_[h]) twin_[h] = kNoHalfEdge;
}

/// On a rough surface, details hardly longer than an element are noise.
void FeatureEdges::findSpecks() {
  constexpr double kRough = 0.7;  // in wanted sizes
  speckAt_.assign(facets_.vertices.size(), limits_.speck);
  for (std::uint32_t t = 0; t < directions_.isRough.size(); ++t)
    if (directions_.isRough[t])
      for (const std::uint32_t v : facets_.triangles[t])
        speckAt_[v] = kRough * limits_.sizeAt(at(v));
}

/// Next to a triangle without area, the angle is unknown.
bool FeatureEdges::isFeature(HalfEdge g, HalfEdge h) const {
  if (forced_.contains(edgeOf(g))) return true;
  if (!areOfOnePart(g, h)) return true;
  const Point3 &m = normals_[g / 3], &n = normals_[h / 3];
  return m != Point3{} && n != Point3{} && angleBetween(m, n) > limits_.angle;
}

bool FeatureEdges::areOfOnePart(HalfEdge g, HalfEdge h) const {
  return facets_.group.empty() || facets_.group[g / 3] == facets_.group[h / 3];
}

void FeatureEdges::smooth(HalfEdge h) {
  twin_[h] = partner_[h];
  twin_[partner_[h]] = h;
}

bool FeatureEdges::isForced(HalfEdge h) const {
  return partner_[h] == kNoHalfEdge || forced_.contains(edgeOf(h));
}

/// Short curves with the same patch on both sides are noise, too: on a rough surface they may
/// hang together.
bool FeatureEdges::dropShortCreases() {
  std::map<FacetEdge, HalfEdge> features;
  for (HalfEdge h = 0; h < twin_.size(); ++h)
    if (twin_[h] == kNoHalfEdge) features[edgeOf(h)] = h;
  bool isAny = false;
  const FeatureCurves all = curves();
  for (const FeatureCurve& curve : all.curves()) {
    std::vector<HalfEdge> along;
    double length = 0;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      along.push_back(features.at(std::minmax(curve[i - 1], curve[i])));
      length += distance(at(curve[i - 1]), at(curve[i]));
    }
    const bool isCrease = std::ranges::all_of(along, [&](HalfEdge h) {
      return !isForced(h) && patchOf_[h / 3] == patchOf_[partner_[h] / 3];
    });
    if (!isCrease || length >= limits_.looseEnd) continue;
    std::ranges::for_each(along, [&](HalfEdge h) { smooth(h); });
    isAny = true;
  }
  return isAny;
}

/// Patches that are far too small to be seen in the mesh.
bool FeatureEdges::dropSpecks() {
  std::vector<double> limits(patchCount_, std::numeric_limits<double>::infinity());
  for (std::uint32_t t = 0; t < patchOf_.size(); ++t)
    for (const std::uint32_t v : facets_.triangles[t])
      limits[patchOf_[t]] = std::min(limits[patchOf_[t]], speckAt_[v]);
  const std::vector<Extent> extents = extentsOfPatches();
  return mergeWithOthers([&](HalfEdge h) {
    const std::size_t p = patchOf_[h / 3];
    return extents[p].across < limits[p];
  });
}

/// By patch: whether the surface around it has one side, so that it is not the rim of a thin wall.
std::vector<bool> FeatureEdges::findOnOneSide() const {
  constexpr double kMostOffMean = 60 * kDegree;
  std::vector<Point3> sums(patchCount_);
  const auto forEachBorder = [&](const auto& visit) {
    for (HalfEdge h = 0; h < twin_.size(); ++h)
      if (mayVanish(h)) visit(patchOf_[h / 3], h, directions_.normals[partner_[h] / 3]);
  };
  forEachBorder([&](std::size_t p, HalfEdge h, const Point3& beside) {
    sums[p] = sums[p] + lengthOf(facets_, h) * beside;
  });
  std::vector<bool> isOnOneSide(patchCount_, true);
  forEachBorder([&](std::size_t p, HalfEdge, const Point3& beside) {
    if (sums[p] == Point3{} || angleBetween(sums[p], beside) > kMostOffMean) isOnOneSide[p] = false;
  });
  return isOnOneSide;
}

/// Patches without width, as rounding leaves them along edges; what is as short as a loose end, or
/// no rim, may be a fold. Edges in roundings do not justify a patch that is narrow compared with
/// the elements.
bool FeatureEdges::dropSlivers() {
  constexpr double kWidth = 0.02, kBesideCrease = 2;  // of a speck
  const std::vector<bool> isOnOneSide = findOnOneSide();
  const std::vector<Extent> extents = extentsOfPatches();
  return mergeWithOthers([&](HalfEdge h) {
    const std::size_t p = patchOf_[h / 3];
    const auto& [perimeter, area, across] = extents[p];
    const bool mayBeFold =
        areOfOnePart(h, partner_[h]) && (across < limits_.looseEnd || isOnOneSide[p]);
    const double share = isCrease_[h] ? kBesideCrease : (mayBeFold ? kFold : kWidth);
    return 2 * area < share * limits_.speck * perimeter;
  });
}

/// Merges patches with the adjacent one with which they share most of their boundary. With another
/// one as well, they would join what they separate.
///
/// isMerged  whether the patch of a half-edge may be merged across it
template <class IsMerged>
bool FeatureEdges::mergeWithOthers(const IsMerged& isMerged) {
  std::vector<std::map<std::size_t, double>> shared(patchCount_);  // only of those to be merged
  std::vector<HalfEdge> along;
  for (HalfEdge h = 0; h < twin_.size(); ++h)
    if (mayVanish(h) && isMerged(h)) {
      shared[patchOf_[h / 3]][patchOf_[partner_[h] / 3]] += lengthOf(facets_, h);
      along.push_back(h);
    }
  std::erase_if(along, [&](HalfEdge h) {
    const auto& beside = shared[patchOf_[h / 3]];
    const auto most = std::ranges::max_element(beside, {}, [](const auto& b) { return b.second; });
    return patchOf_[partner_[h] / 3] != most->first;
  });
  lookAcross(along);
  std::ranges::for_each(along, [&](HalfEdge h) { smooth(h); });
  return !along.empty();
}

/// The triangles of patches that vanish get the normals of those beside them.
///
/// borders  of these patches, which vanish as well
void FeatureEdges::lookAcross(const std::vector<HalfEdge>& borders) {
  std::vector<std::uint32_t> reached;
  std::vector<bool> isReached(facets_.triangles.size(), false);
  const auto reach = [&](std::uint32_t t, const Point3& normal) {
    if (isReached[t]) return;
    isReached[t] = true;
    normals_[t] = normal;
    reached.push_back(t);
  };
  const std::vector<Point3> before = normals_;
  for (const HalfEdge h : borders) reach(h / 3, before[partner_[h] / 3]);
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (HalfEdge h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h)
      if (twin_[h] != kNoHalfEdge) reach(twin_[h] / 3, normals_[reached[i]]);
}

/// By vertex: how many feature edges meet there.
std::vector<int> FeatureEdges::countAround() const {
  std::vector<int> counts(facets_.vertices.size(), 0);
  for (HalfEdge h = 0; h < twin_.size(); ++h)
    if (twin_[h] == kNoHalfEdge && h < partner_[h]) {
      ++counts[startOf(facets_.triangles, h)];
      ++counts[endOf(facets_.triangles, h)];
    }
  return counts;
}

/// Triangles too narrow to be seen in which the border of a patch turns back are moved to the other
/// side of it. Where it turns back anyway, the patch has a tip, which stays.
bool FeatureEdges::dropSpikes() {
  constexpr double kTurnsBack = 150 * kDegree;
  const std::vector<int> around = countAround();
  const auto along = [&](HalfEdge h) { return startAt(nextIn(h)) - startAt(h); };
  bool isAny = false;
  for (HalfEdge h = 0; h < twin_.size(); ++h) {
    const HalfEdge next = nextIn(h), third = previousIn(h);
    if (!mayVanish(h) || !mayVanish(next) || twin_[third] == kNoHalfEdge) continue;
    const std::size_t own = patchOf_[h / 3], other = patchOf_[partner_[h] / 3];
    if (own == other || patchOf_[partner_[next] / 3] != other ||
        around[startOf(facets_.triangles, next)] != 2)
      continue;
    const double longest = std::max(length(along(h)), length(along(next)));
    if (2 * areaOf(facets_, h / 3) >= kFold * limits_.speck * longest ||
        angleBetween(along(h), along(next)) <= kTurnsBack)
      continue;
    const HalfEdge before = previousAround(twin_, twin_[third]);
    const HalfEdge after = nextAround(twin_, twin_[third]);
    if (angleBetween(along(before), along(after)) > kTurnsBack) continue;  // the tip of a patch
    twin_[twin_[third]] = kNoHalfEdge;
    twin_[third] = kNoHalfEdge;
    smooth(h);
    smooth(next);
    patchOf_[h / 3] = other;
    normals_[h / 3] = normals_[partner_[h] / 3];
    isAny = true;
  }
  return isAny;
}

void FeatureEdges::findPatchOf() {
  patchCount_ = 0;
  constexpr std::size_t kUnknown = ~std::size_t{0};
  patchOf_.assign(facets_.triangles.size(), kUnknown);
  for (std::uint32_t first = 0; first < patchOf_.size(); ++first) {
    if (patchOf_[first] != kUnknown) continue;
    patchOf_[first] = patchCount_;
    flood(twin_, first, [&](std::uint32_t t) {
      if (patchOf_[t] != kUnknown) return false;
      patchOf_[t] = patchCount_;
      return true;
    });
    ++patchCount_;
  }
}

}  // namespace af2::geometry
