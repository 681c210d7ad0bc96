#include "geometry/faceted/cones.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "engine/base/elementary.h"
#include "geometry/faceted/flats.h"

namespace af2::geometry {
namespace {

class ConeCut {
 public:
  ConeCut(const PatchedFacets& patched, const Patch& patch, double angle, double size)
      : whole_(patched), patch_(patch), angle_(angle), size_(size) {
    take();
    findTwins();
    flats_ = findFlats(facets_, twins_, normals_);
  }

  std::set<FacetEdge> borders() {
    grow();
    straighten();
    while (dropNarrow()) {
    }
    straighten();
    std::set<FacetEdge> edges;
    for (HalfEdge h = 0; h < twins_.size(); ++h)
      if (isBorder(h)) edges.insert(edgeOf(h));
    return edges;
  }

 private:
  FacetEdge edgeOf(HalfEdge h) const { return geometry::edgeOf(facets_.triangles, h); }
  bool isBorder(HalfEdge h) const {
    return twins_[h] != kNoHalfEdge && piece_[h / 3] != piece_[twins_[h] / 3];
  }

  void take() {
    facets_.vertices = whole_.facets.vertices;
    for (const std::uint32_t t : patch_.triangles) {
      facets_.triangles.push_back(whole_.facets.triangles[t]);
      normals_.push_back(whole_.normals[t]);
    }
  }

  void findTwins() {
    std::set<FacetEdge> kept;
    for (const auto& loop : patch_.loops)
      for (const CurveUse& use : loop) {
        const FeatureCurve& curve = whole_.curves[use.curve];
        for (std::size_t i = 1; i < curve.size(); ++i)
          kept.insert(std::minmax(curve[i - 1], curve[i]));
      }
    twins_ = orientedTwins(facets_.triangles);
    for (HalfEdge h = 0; h < twins_.size(); ++h)
      if (kept.contains(edgeOf(h))) twins_[h] = kNoHalfEdge;
  }

  /// From the largest flat that is left, in the order of the angle to it. Triangles without a
  /// direction are in no cone.
  void grow() {
    const double kCone = cosine(angle_);
    std::vector<std::uint32_t> order(flats_.flats.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::ranges::greater(),
                             [&](std::uint32_t f) { return flats_.flats[f].area; });
    std::vector<std::uint32_t> first(order.size(), kNoHalfEdge);
    for (std::uint32_t t = 0; t < flats_.of.size(); ++t)
      first[flats_.of[t]] = std::min(first[flats_.of[t]], t);
    piece_.assign(flats_.of.size(), kNoHalfEdge);
    for (const std::uint32_t flat : order) {
      if (piece_[first[flat]] != kNoHalfEdge) continue;
      axes_.push_back(flats_.flats[flat].normal);
      growPiece(first[flat], kCone);
    }
    for (std::uint32_t t = 0; t < piece_.size(); ++t) {
      if (piece_[t] != kNoHalfEdge) continue;
      axes_.push_back(flats_.flats[flats_.of[t]].normal);
      growPiece(t, kCone);
    }
  }

  void growPiece(std::uint32_t start, double cone) {
    const auto piece = static_cast<std::uint32_t>(axes_.size() - 1);
    piece_[start] = piece;
    flood(twins_, start, [&](std::uint32_t other) {
      if (piece_[other] != kNoHalfEdge || !(along(other, piece) > cone)) return false;
      piece_[other] = piece;
      return true;
    });
  }
  /// Of flats, so that noise within them does not count.
  double along(std::uint32_t t, std::uint32_t piece) const {
    return dot(flats_.flats[flats_.of[t]].normal, axes_[piece]);
  }

  /// A triangle stays in the cone of its piece, or not far beyond.
  void straighten() {
    const double widest = cosine(4 * angle_ / 3);
    straightenBorders(
        facets_, twins_, piece_, [&](HalfEdge h) { return isBorder(h); },
        [&](std::uint32_t t, std::uint32_t piece) { return along(t, piece) > widest; });
  }

  /// Narrow pieces become part of those with which they share most of their borders.
  bool dropNarrow() {
    constexpr double kWidth = 0.4;  // in wanted sizes
    const std::vector<Flat> extents = extentsOfPieces();
    std::map<std::uint32_t, std::map<std::uint32_t, double>> shared;  // only of narrow ones
    for (HalfEdge h = 0; h < twins_.size(); ++h)
      if (isBorder(h) && extents[piece_[h / 3]].width() < kWidth * size_)
        shared[piece_[h / 3]][piece_[twins_[h] / 3]] += lengthOf(facets_, h);
    std::vector<std::uint32_t> became(axes_.size());
    std::iota(became.begin(), became.end(), 0u);
    std::set<std::uint32_t> grown, gone;  // their borders are others now: they wait for a round
    for (const auto& [piece, beside] : shared) {
      const auto most =
          std::ranges::max_element(beside, {}, [](const auto& b) { return b.second; });
      if (grown.contains(piece) || gone.contains(most->first)) continue;
      became[piece] = most->first;
      grown.insert(most->first);
      gone.insert(piece);
    }
    for (std::uint32_t& piece : piece_) piece = became[piece];
    return !gone.empty();
  }

  std::vector<Flat> extentsOfPieces() const {
    std::vector<Flat> extents(axes_.size());
    for (std::uint32_t t = 0; t < piece_.size(); ++t) extents[piece_[t]].area += areaOf(facets_, t);
    for (HalfEdge h = 0; h < twins_.size(); ++h)
      if (twins_[h] == kNoHalfEdge || isBorder(h))
        extents[piece_[h / 3]].perimeter += lengthOf(facets_, h);
    return extents;
  }

  const PatchedFacets& whole_;
  const Patch& patch_;
  double angle_, size_;
  Facets facets_;  // of the patch
  std::vector<Point3> normals_;
  std::vector<HalfEdge> twins_;
  Flats flats_;
  std::vector<std::uint32_t> piece_;  // by triangle
  std::vector<Point3> axes_;          // by piece
};

}  // namespace

std::set<FacetEdge> coneBorders(const PatchedFacets& patched, const Patch& patch, double angle,
                                double size) {
  return ConeCut(patched, patch, angle, size).borders();
}

}  // namespace af2::geometry
