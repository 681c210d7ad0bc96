#include "geometry/faceted/blends.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <tuple>

#include "engine/base/elementary.h"
#include "geometry/base/constants.h"

namespace af2::geometry {
namespace {

class Sharpening {
 public:
  Sharpening(const Facets& facets, const std::vector<HalfEdge>& twins, std::vector<Point3> normals,
             const BlendLimits& limits)
      : facets_(facets),
        twins_(twins),
        limits_(limits),
        normals_(std::move(normals)),
        flats_(findFlats(facets, twins, normals_)) {}

  SharpBlends sharpen() {
    findBlends();
    takeNarrowRest();
    spread();
    straighten();
    SharpBlends result{std::vector<bool>(twins_.size(), false), normals_};
    for (HalfEdge h = 0; h < twins_.size(); ++h) result.isCrease[h] = isCrease(h);
    for (std::uint32_t t = 0; t < normals_.size(); ++t)
      if (isBlend(t) && owner_[t] != kNoHalfEdge)
        result.normals[t] = flats_.flats[owner_[t]].normal;
    return result;
  }

 private:
  bool isBlend(std::uint32_t t) const { return isFlatBlend_[flats_.of[t]]; }
  double sizeIn(std::uint32_t t) const { return limits_.sizeAt(middleOf(facets_, t)); }
  /// The width of the adjacent flat, in wanted sizes. The distance of triangles would not do,
  /// because triangles of strips are long.
  double stepFrom(std::uint32_t from, std::uint32_t to) const {
    if (flats_.of[from] == flats_.of[to]) return 0;
    return flats_.flats[flats_.of[to]].width() / sizeIn(to);
  }

  /// Finds roundings by the angle between a flat and its neighbours, compared with the width of the
  /// flat.
  void findBlends() {
    constexpr double kRadius = 0.25;      // in wanted sizes
    const double kMinTurn = 4 * kDegree;  // less is noise
    isFlatBlend_.assign(flats_.flats.size(), false);
    for (HalfEdge h = 0; h < twins_.size(); ++h) {
      if (twins_[h] == kNoHalfEdge || isBlend(h / 3)) continue;
      const std::uint32_t own = flats_.of[h / 3], other = flats_.of[twins_[h] / 3];
      const Flat& flat = flats_.flats[own];
      const double turn = angleBetween(flat.normal, flats_.flats[other].normal);
      if (own == other || turn < kMinTurn) continue;
      isFlatBlend_[own] = turn * kRadius * limits_.sizeAt(flat.middle) > flat.width();
    }
  }

  /// A narrow rest between blends, hardly wider than they are, is not a surface that they join.
  void takeNarrowRest() {
    constexpr double kWidth = 0.08;  // in wanted sizes
    std::vector<bool> seen(flats_.of.size(), false);
    for (std::uint32_t first = 0; first < seen.size(); ++first) {
      if (seen[first] || isBlend(first)) continue;
      const std::vector<std::uint32_t> rest = restAround(first, seen);
      double area = 0, perimeter = 0;
      bool isBesideBlend = false;
      for (const std::uint32_t t : rest) {
        area += areaOf(facets_, t);
        for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
          const bool isInside = twins_[h] != kNoHalfEdge && !isBlend(twins_[h] / 3);
          if (!isInside) perimeter += lengthOf(facets_, h);
          isBesideBlend = isBesideBlend || (twins_[h] != kNoHalfEdge && !isInside);
        }
      }
      if (!isBesideBlend || 2 * area >= kWidth * sizeIn(first) * perimeter) continue;
      for (const std::uint32_t t : rest) isFlatBlend_[flats_.of[t]] = true;
    }
  }
  std::vector<std::uint32_t> restAround(std::uint32_t first, std::vector<bool>& seen) const {
    std::vector<std::uint32_t> rest{first};
    seen[first] = true;
    for (std::size_t i = 0; i < rest.size(); ++i)
      for (HalfEdge h = 3 * rest[i]; h < 3 * rest[i] + 3; ++h) {
        if (twins_[h] == kNoHalfEdge || seen[twins_[h] / 3] || isBlend(twins_[h] / 3)) continue;
        seen[twins_[h] / 3] = true;
        rest.push_back(twins_[h] / 3);
      }
    return rest;
  }

  /// Gives each triangle of a blend the flat from which it is reached with the least turning.
  void spread() {
    constexpr double kReach = 0.5;       // in wanted sizes
    constexpr double kTurnOfSize = 0.5;  // radians that count as much as a way of one size
    owner_ = flats_.of;
    std::vector<double> turned(owner_.size(), 0), way(owner_.size(), 0);
    // What it costs, the triangle, the one before, and the owner.
    using Entry = std::tuple<double, std::uint32_t, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto offer = [&](std::uint32_t from) {
      for (HalfEdge h = 3 * from; h < 3 * from + 3; ++h) {
        if (twins_[h] == kNoHalfEdge) continue;
        const std::uint32_t to = twins_[h] / 3;
        if (owner_[to] != kNoHalfEdge) continue;
        const double turn = angleBetween(normals_[from], normals_[to]), step = stepFrom(from, to);
        if (way[from] + step > kReach) continue;
        open.push({turned[from] + turn + kTurnOfSize * step, to, from});
      }
    };
    for (std::uint32_t t = 0; t < owner_.size(); ++t)
      if (isBlend(t)) owner_[t] = kNoHalfEdge;
    for (std::uint32_t t = 0; t < owner_.size(); ++t)
      if (!isBlend(t)) offer(t);
    while (!open.empty()) {
      const auto [cost, t, from] = open.top();
      open.pop();
      if (owner_[t] != kNoHalfEdge) continue;
      owner_[t] = owner_[from];
      turned[t] = cost;
      way[t] = way[from] + stepFrom(from, t);
      offer(t);
    }
  }

  bool differ(std::uint32_t p, std::uint32_t q) const {
    return p != kNoHalfEdge && q != kNoHalfEdge && p != q &&
           angleBetween(flats_.flats[p].normal, flats_.flats[q].normal) > limits_.angle;
  }
  bool isCrease(HalfEdge h) const {
    if (twins_[h] == kNoHalfEdge) return false;
    const std::uint32_t t = h / 3, other = twins_[h] / 3;
    return (isBlend(t) || isBlend(other)) && differ(owner_[t], owner_[other]);
  }

  /// Creases that run to and fro between the triangles become shorter.
  void straighten() {
    straightenBorders(
        facets_, twins_, owner_, [&](HalfEdge h) { return isCrease(h); },
        [&](std::uint32_t t, std::uint32_t owner) {
          return isBlend(t) && owner_[t] != kNoHalfEdge && owner != kNoHalfEdge;
        });
  }

  const Facets& facets_;
  const std::vector<HalfEdge>& twins_;
  const BlendLimits& limits_;
  std::vector<Point3> normals_;  // by triangle
  Flats flats_;
  std::vector<bool> isFlatBlend_;     // by flat
  std::vector<std::uint32_t> owner_;  // by triangle: the flat that it is of in the end
};

}  // namespace

SharpBlends sharpenBlends(const Facets& facets, const std::vector<std::uint32_t>& twins,
                          std::vector<Point3> normals, const BlendLimits& limits) {
  if (!limits.sizeAt) return {std::vector<bool>(twins.size(), false), std::move(normals)};
  return Sharpening(facets, twins, std::move(normals), limits).sharpen();
}

}  // namespace af2::geometry
