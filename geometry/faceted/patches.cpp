#include "geometry/faceted/patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "engine/base/elementary.h"
#include "geometry/base/box_tree.h"
#include "geometry/faceted/blends.h"
#include "geometry/faceted/directions.h"
#include "geometry/faceted/plane_cut.h"

namespace af2::geometry {
namespace {

using Edge = FacetEdge;

class PatchFinder {
 public:
  PatchFinder(const Facets& facets, const FacetDirections& directions, const FeatureLimits& limits,
              const std::set<Edge>& forced)
      : facets_(facets),
        isRough_(directions.isRough),
        limits_(limits),
        angle_(limits.angle),
        forced_(forced),
        normals_(directions.normals) {
    findTwins();
    findPatchOf();
    while (dropShortCreases()) {
    }
    if (dropSpecks()) findPatchOf();
    if (dropSlivers()) findPatchOf();
  }

  /// Triangles of each patch that has too little boundary to start from, e.g. none. A flat patch
  /// has at least the perimeter of a disc of its area.
  std::vector<std::vector<std::uint32_t>> bulgingPatches() const {
    constexpr double kShareOfDisc = 0.5;
    const std::vector<Extent> extents = extentsOfPatches();
    const auto isBulging = [&](std::size_t p) {
      return extents[p].perimeter <
             kShareOfDisc * std::sqrt(4 * std::numbers::pi * extents[p].area);
    };
    std::vector<std::vector<std::uint32_t>> triangles(patchCount_);
    for (std::uint32_t t = 0; t < patchOf_.size(); ++t)
      if (isBulging(patchOf_[t])) triangles[patchOf_[t]].push_back(t);
    std::erase_if(triangles, [](const auto& patch) { return patch.empty(); });
    return triangles;
  }

  PatchedFacets find() {
    findCurves();
    std::vector<Patch> patches(patchCount_);
    for (std::uint32_t t = 0; t < patchOf_.size(); ++t) patches[patchOf_[t]].triangles.push_back(t);
    addLoops(patches);
    return {facets_, {}, std::move(normals_), std::move(curves_), std::move(patches), forced_};
  }

 private:
  struct Extent {
    double perimeter = 0, area = 0;
  };
  std::vector<Extent> extentsOfPatches() const {
    std::vector<Extent> extents(patchCount_);
    for (HalfEdge h = 0; h < twin_.size(); ++h)
      if (twin_[h] == kNoHalfEdge) extents[patchOf_[h / 3]].perimeter += lengthOf(facets_, h);
    for (std::uint32_t t = 0; t < patchOf_.size(); ++t) {
      const auto& c = facets_.triangles[t];
      extents[patchOf_[t]].area += length(cross(at(c[1]) - at(c[0]), at(c[2]) - at(c[0]))) / 2;
    }
    return extents;
  }

  Edge edgeOf(HalfEdge h) const { return geometry::edgeOf(facets_.triangles, h); }
  const Point3& at(std::uint32_t v) const { return facets_.vertices[v]; }
  void findTwins() {
    twin_ = partner_ = orientedTwins(facets_);
    findSpecks();
    std::vector<bool> isFeatureEdge(twin_.size(), false);
    for (HalfEdge h = 0; h < twin_.size(); ++h)
      isFeatureEdge[h] = twin_[h] != kNoHalfEdge && isFeature(h, twin_[h]);
    for (HalfEdge h = 0; h < twin_.size(); ++h)
      if (isFeatureEdge[h]) twin_[h] = kNoHalfEdge;
    SharpBlends sharp =
        sharpenBlends(facets_, twin_, std::move(normals_), {angle_, limits_.sizeAt});
    normals_ = std::move(sharp.normals);
    isCrease_ = std::move(sharp.isCrease);
    for (HalfEdge h = 0; h < twin_.size(); ++h)
      if (isCrease_[h]) twin_[h] = kNoHalfEdge;
  }

  /// On a rough surface, details hardly longer than an element are noise.
  void findSpecks() {
    constexpr double kRough = 0.7;  // in wanted sizes
    speckAt_.assign(facets_.vertices.size(), limits_.speck);
    for (std::uint32_t t = 0; t < isRough_.size(); ++t)
      if (isRough_[t])
        for (const std::uint32_t v : facets_.triangles[t])
          speckAt_[v] = kRough * limits_.sizeAt(at(v));
  }

  /// Next to a triangle without area, the angle is unknown.
  bool isFeature(HalfEdge g, HalfEdge h) const {
    if (forced_.contains(edgeOf(g))) return true;
    if (!facets_.group.empty() && facets_.group[g / 3] != facets_.group[h / 3]) return true;
    const Point3 &m = normals_[g / 3], &n = normals_[h / 3];
    return m != Point3{} && n != Point3{} && angleBetween(m, n) > angle_;
  }

  void smooth(HalfEdge h) {
    twin_[h] = partner_[h];
    twin_[partner_[h]] = h;
  }

  bool isForced(HalfEdge h) const {
    return partner_[h] == kNoHalfEdge || forced_.contains(edgeOf(h));
  }

  /// Short curves with the same patch on both sides are noise, too: on a rough surface they may
  /// hang together.
  bool dropShortCreases() {
    std::map<Edge, HalfEdge> features;
    for (HalfEdge h = 0; h < twin_.size(); ++h)
      if (twin_[h] == kNoHalfEdge) features[edgeOf(h)] = h;
    findCurves();
    bool isAny = false;
    for (const FeatureCurve& curve : curves_) {
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
    beside_.clear();
    places_.clear();
    curves_.clear();
    return isAny;
  }

  /// Patches that are far too small to be seen in the mesh become part of those around them.
  bool dropSpecks() {
    std::vector<Box3> boxes(patchCount_);
    std::vector<double> limits(patchCount_, std::numeric_limits<double>::infinity());
    for (std::uint32_t t = 0; t < patchOf_.size(); ++t)
      for (const std::uint32_t v : facets_.triangles[t]) {
        boxes[patchOf_[t]].add(at(v));
        limits[patchOf_[t]] = std::min(limits[patchOf_[t]], speckAt_[v]);
      }
    bool isAny = false;
    for (HalfEdge h = 0; h < twin_.size(); ++h) {
      const Box3& box = boxes[patchOf_[h / 3]];
      if (twin_[h] != kNoHalfEdge || isForced(h) ||
          distance(box.low, box.high) >= limits[patchOf_[h / 3]])
        continue;
      smooth(h);
      isAny = true;
    }
    return isAny;
  }

  /// Patches without width, as rounding leaves them along edges, are merged with the adjacent patch
  /// with which they share most of their boundary. Edges in roundings do not justify a patch that
  /// is narrow compared with the elements.
  bool dropSlivers() {
    constexpr double kWidth = 0.02, kBesideCrease = 2;  // of a speck
    const std::vector<Extent> extents = extentsOfPatches();
    const auto isOfSliver = [&](HalfEdge h) {
      if (twin_[h] != kNoHalfEdge || isForced(h)) return false;
      const auto& [perimeter, area] = extents[patchOf_[h / 3]];
      const double width = limits_.speck * (isCrease_[h] ? kBesideCrease : kWidth);
      return 2 * area < width * perimeter;
    };
    std::vector<std::map<std::size_t, double>> shared(patchCount_);  // only of slivers
    for (HalfEdge h = 0; h < twin_.size(); ++h)
      if (isOfSliver(h)) shared[patchOf_[h / 3]][patchOf_[partner_[h] / 3]] += lengthOf(facets_, h);
    bool isAny = false;
    for (HalfEdge h = 0; h < twin_.size(); ++h) {
      const auto& beside = shared[patchOf_[h / 3]];
      if (!isOfSliver(h)) continue;
      const auto most =
          std::ranges::max_element(beside, {}, [](const auto& b) { return b.second; });
      if (patchOf_[partner_[h] / 3] != most->first) continue;
      smooth(h);
      isAny = true;
    }
    return isAny;
  }

  void findPatchOf() {
    patchCount_ = 0;
    constexpr std::size_t kUnknown = ~std::size_t{0};
    patchOf_.assign(facets_.triangles.size(), kUnknown);
    std::vector<std::uint32_t> open;
    for (std::uint32_t first = 0; first < patchOf_.size(); ++first) {
      if (patchOf_[first] != kUnknown) continue;
      open.push_back(first);
      patchOf_[first] = patchCount_;
      while (!open.empty()) {
        const std::uint32_t t = open.back();
        open.pop_back();
        for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
          if (twin_[h] == kNoHalfEdge || patchOf_[twin_[h] / 3] != kUnknown) continue;
          patchOf_[twin_[h] / 3] = patchCount_;
          open.push_back(twin_[h] / 3);
        }
      }
      ++patchCount_;
    }
  }

  void findCurves() {
    std::set<Edge> edges;
    for (HalfEdge h = 0; h < twin_.size(); ++h)
      if (twin_[h] == kNoHalfEdge) edges.insert(edgeOf(h));
    for (const auto& [a, b] : edges) {
      beside_[a].push_back(b);
      beside_[b].push_back(a);
    }
    for (const auto& [v, others] : beside_)
      if (isCorner(v))
        for (const std::uint32_t other : others) follow(v, other);
    for (const auto& [v, others] : beside_) follow(v, others.front());  // what is closed
  }

  /// Curves that go back and forth within less than a speck do not turn.
  bool isCorner(std::uint32_t v) const {
    const std::vector<std::uint32_t>& others = beside_.at(v);
    if (others.size() != 2) return true;
    if (!(angleBetween(at(v) - at(others[0]), at(others[1]) - at(v)) > angle_)) return false;
    const Point3 before = at(v) - at(beyondSpeck(v, others[0]));
    return angleBetween(before, at(beyondSpeck(v, others[1])) - at(v)) > angle_;
  }
  /// The first vertex from `next` on that is farther from `from` than a speck.
  std::uint32_t beyondSpeck(std::uint32_t from, std::uint32_t next) const {
    std::uint32_t before = from;
    while (distance(at(from), at(next)) < speckAt_[from]) {
      const std::vector<std::uint32_t>& others = beside_.at(next);
      if (others.size() != 2) break;
      const std::uint32_t after = others[0] == before ? others[1] : others[0];
      if (after == from) break;
      before = next;
      next = after;
    }
    return next;
  }

  void follow(std::uint32_t from, std::uint32_t to) {
    if (places_.contains(std::minmax(from, to))) return;
    FeatureCurve curve{from};
    while (true) {
      places_[std::minmax(from, to)] = {curves_.size(), curve.size() - 1, from};
      curve.push_back(to);
      if (to == curve.front() || isCorner(to)) break;
      const std::vector<std::uint32_t>& others = beside_.at(to);
      const std::uint32_t next = others[0] == from ? others[1] : others[0];
      from = to;
      to = next;
    }
    curves_.push_back(std::move(curve));
  }

  /// The feature edge after `h` around its patch.
  HalfEdge nextAround(HalfEdge h) const {
    HalfEdge next = nextIn(h);
    while (twin_[next] != kNoHalfEdge) next = nextIn(twin_[next]);
    return next;
  }

  void addLoops(std::vector<Patch>& patches) const {
    std::vector<bool> seen(twin_.size(), false);
    for (HalfEdge first = 0; first < twin_.size(); ++first) {
      if (twin_[first] != kNoHalfEdge || seen[first]) continue;
      std::vector<CurveUse> loop;
      for (HalfEdge h = first; !seen[h]; h = nextAround(h)) {
        seen[h] = true;
        const Place& place = places_.at(edgeOf(h));
        const bool reversed = startOf(facets_.triangles, h) != place.from;
        const std::size_t start = reversed ? curves_[place.curve].size() - 2 : 0;
        if (place.index == start) loop.push_back({place.curve, reversed});
      }
      patches[patchOf_[first / 3]].loops.push_back(std::move(loop));
    }
  }

  struct Place {
    std::size_t curve = 0, index = 0;
    std::uint32_t from = 0;
  };
  const Facets& facets_;
  const std::vector<bool>& isRough_;  // by triangle
  const FeatureLimits& limits_;
  double angle_;
  const std::set<Edge>& forced_;
  std::vector<HalfEdge> partner_;     // kNoHalfEdge at edges that have not two triangles
  std::vector<HalfEdge> twin_;        // the same, but kNoHalfEdge at feature edges
  std::vector<Point3> normals_;       // by triangle
  std::vector<double> speckAt_;       // by vertex: what is smaller cannot be seen
  std::vector<bool> isCrease_;        // amid a rounding
  std::vector<std::size_t> patchOf_;  // by triangle
  std::size_t patchCount_ = 0;
  std::map<std::uint32_t, std::vector<std::uint32_t>> beside_;  // by vertex, over feature edges
  std::map<Edge, Place> places_;                                // of feature edges in curves
  std::vector<FeatureCurve> curves_;
};

PatchedFacets patchesBetween(Facets facets, FacetDirections directions, const FeatureLimits& limits,
                             std::set<Edge> cuts) {
  constexpr int kMaxRounds = 30;
  for (int round = 0;; ++round) {
    PatchFinder finder(facets, directions, limits, cuts);
    const auto bulging = finder.bulgingPatches();
    if (bulging.empty() || round == kMaxRounds) {
      PatchedFacets patched = finder.find();
      patched.directions = std::move(directions);
      return patched;
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
  return patchesBetween(patched.facets, patched.directions, limits, std::move(all));
}

}  // namespace af2::geometry
