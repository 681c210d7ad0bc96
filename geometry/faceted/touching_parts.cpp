#include "geometry/faceted/touching_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>

#include "engine/base/elementary.h"
#include "geometry/base/disjoint_sets.h"
#include "geometry/base/plane_axes.h"
#include "geometry/faceted/half_edges.h"

namespace af2::geometry {
namespace {

/// A triangle beside an edge with more than two.
struct Wing {
  HalfEdge half = kNoHalfEdge;
  double angle = 0;      ///< around the edge
  bool isAlong = false;  ///< runs from its lower vertex to the higher; material is below the angle
};

class Parting {
 public:
  explicit Parting(Facets& facets)
      : facets_(facets), parts_(facets.triangles.size()), isOpen_(facets.triangles.size(), false) {}

  void part() {
    joinAcrossEdges();
    if (crowded_.empty() && !hasSharedVertices()) return;
    closeParts();
    keepCommonWalls();
    giveOwnVertices();
  }

 private:
  std::uint32_t startOf(HalfEdge h) const { return geometry::startOf(facets_.triangles, h); }
  const Point3& at(std::uint32_t v) const { return facets_.vertices[v]; }

  void joinAcrossEdges() {
    HalfEdges(facets_.triangles).forEachEdge([&](const FacetEdge& edge, auto halves) {
      if (halves.size() == 1) isOpen_[halves[0] / 3] = true;
      if (halves.size() == 2) parts_.join(halves[0] / 3, halves[1] / 3);
      if (halves.size() > 2) joinAround(edge, halves);
    });
  }

  void joinAround(const FacetEdge& edge, std::span<const HalfEdge> halves) {
    const std::vector<Wing> wings = wingsOf(edge, halves);
    const auto along = std::ranges::count_if(wings, &Wing::isAlong);
    if (2 * along != std::ssize(wings)) {
      for (const Wing& wing : wings) {
        parts_.join(wing.half / 3, wings.front().half / 3);
        isOpen_[wing.half / 3] = true;
      }
      return;
    }
    joinMaterial(wings);
    crowded_.push_back(wings);
  }

  /// Material begins at what runs against the edge, and ends at what runs along it. Where parts
  /// reach into each other a little, as a pin in a hole with other triangles, what began first ends
  /// first: neither is inside the other.
  void joinMaterial(const std::vector<Wing>& wings) {
    std::deque<std::uint32_t> begun;
    const std::size_t first = beginning(wings);
    for (std::size_t i = 0; i < wings.size(); ++i) {
      const Wing& wing = wings[(first + i) % wings.size()];
      if (!wing.isAlong) {
        begun.push_back(wing.half / 3);
        continue;
      }
      parts_.join(begun.front(), wing.half / 3);
      begun.pop_front();
    }
  }

  /// The wings sorted by angle. At equal angles, where parts touch, the wing at which material ends
  /// comes first.
  std::vector<Wing> wingsOf(const FacetEdge& edge, std::span<const HalfEdge> halves) const {
    const auto [low, high] = edge;
    const PlaneAxes axes(at(low), unit(at(high) - at(low)));
    std::vector<Wing> wings;
    for (const HalfEdge h : halves) {
      const Point3 apex = at(startOf(previousIn(h))) - at(low);
      const double angle = angleOf({dot(apex, axes.xAxis()), dot(apex, axes.yAxis())});
      wings.push_back({h, angle, startOf(h) == low});
    }
    std::ranges::sort(wings, [](const Wing& p, const Wing& q) {
      return std::pair(p.angle, p.half) < std::pair(q.angle, q.half);
    });
    std::ranges::rotate(wings, wings.begin() + afterWidestGap(wings));
    for (std::size_t i = 1; i < wings.size(); ++i)
      for (std::size_t k = i; k > 0 && areTogether(wings[k - 1], wings[k]); --k)
        if (comesBefore(wings[k], wings[k - 1])) std::swap(wings[k], wings[k - 1]);
    return wings;
  }
  /// The order of two wings at the same angle. If several solids coincide, which are consecutive in
  /// the file, each stays separate.
  static bool comesBefore(const Wing& p, const Wing& q) {
    if (p.isAlong != q.isAlong) return p.isAlong;
    return p.half < q.half;
  }
  static std::ptrdiff_t afterWidestGap(const std::vector<Wing>& wings) {
    std::size_t widest = 0;
    const auto gapBefore = [&](std::size_t i) {
      return i > 0 ? wings[i].angle - wings[i - 1].angle
                   : wings[0].angle - wings.back().angle + 2 * std::numbers::pi;
    };
    for (std::size_t i = 1; i < wings.size(); ++i)
      if (gapBefore(i) > gapBefore(widest)) widest = i;
    return static_cast<std::ptrdiff_t>(widest);
  }
  /// Radians: what is on each other, and what would be if curved walls had the same triangles.
  static constexpr double kSame = 1e-3, kNear = 0.35;
  static bool areTogether(const Wing& p, const Wing& q, double most = kSame) {
    return std::abs(std::remainder(p.angle - q.angle, 2 * std::numbers::pi)) < most;
  }

  /// The first wing from which on material never ends before it has begun.
  static std::size_t beginning(const std::vector<Wing>& wings) {
    std::size_t first = 0;
    int depth = 0, least = 0;
    for (std::size_t i = 0; i < wings.size(); ++i) {
      depth += wings[i].isAlong ? -1 : 1;
      if (depth >= least) continue;
      least = depth;
      first = i + 1;
    }
    return first % wings.size();
  }

  /// Whether any vertex is used by several parts.
  bool hasSharedVertices() {
    std::vector<std::uint32_t> user(facets_.vertices.size(), kNoHalfEdge);
    for (std::uint32_t t = 0; t < facets_.triangles.size(); ++t)
      for (const std::uint32_t v : facets_.triangles[t]) {
        if (user[v] != kNoHalfEdge && user[v] != parts_.of(t)) return true;
        user[v] = parts_.of(t);
      }
    return false;
  }

  /// Open parts stay joined with everything that they touch.
  void closeParts() {
    std::set<std::uint32_t> open;
    for (std::uint32_t t = 0; t < isOpen_.size(); ++t)
      if (isOpen_[t]) open.insert(parts_.of(t));
    for (const std::uint32_t part : open) parts_.join(part, *open.begin());
  }

  /// Two parts stay together if triangles of both coincide, unless triangles overlap only in part,
  /// or continue next to each other, as those of a pin in its hole.
  void keepCommonWalls() {
    std::set<FacetEdge> common, overlapping;  // pairs of parts
    for (const auto& wings : crowded_)
      for (const Wing& p : wings)
        for (const Wing& q : wings) {
          const FacetEdge pair = std::minmax(parts_.of(p.half / 3), parts_.of(q.half / 3));
          if (pair.first == pair.second || !areTogether(p, q, kNear)) continue;
          const bool isWall = p.isAlong != q.isAlong && areTwins(p.half / 3, q.half / 3);
          (isWall ? common : overlapping).insert(pair);
        }
    for (const FacetEdge& pair : common)
      if (!overlapping.contains(pair)) parts_.join(pair.first, pair.second);
  }
  bool areTwins(std::uint32_t t, std::uint32_t other) const {
    auto p = facets_.triangles[t], q = facets_.triangles[other];
    std::ranges::sort(p);
    std::ranges::sort(q);
    return p == q;
  }

  /// The first part at a vertex keeps it.
  void giveOwnVertices() {
    std::vector<std::uint32_t> first(facets_.vertices.size(), kNoHalfEdge);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> copies;  // by vertex and part
    std::set<std::uint32_t> apart;
    std::optional<Point3> place;
    for (std::uint32_t t = 0; t < facets_.triangles.size(); ++t)
      for (std::uint32_t& v : facets_.triangles[t]) {
        const std::uint32_t part = parts_.of(t);
        if (first[v] == kNoHalfEdge) first[v] = part;
        if (first[v] == part) continue;
        if (!place) place = at(v);
        apart.insert({part, first[v]});
        const auto [copy, isNew] =
            copies.try_emplace({v, part}, static_cast<std::uint32_t>(facets_.vertices.size()));
        if (isNew) facets_.vertices.push_back(Point3(at(v)));
        v = copy->second;
      }
    if (!place) return;
    char text[200];
    std::snprintf(text, sizeof text,
                  "%zu parts that touch each other were separated, the first near (%.9g, %.9g, "
                  "%.9g)",
                  apart.size(), place->x, place->y, place->z);
    facets_.notes.emplace_back(text);
  }

  Facets& facets_;
  DisjointSets parts_;                      // by triangle
  std::vector<bool> isOpen_;                // by triangle: at an edge that no other one pairs with
  std::vector<std::vector<Wing>> crowded_;  // edges with more than two triangles
};

}  // namespace

void partTouching(Facets& facets) { Parting(facets).part(); }

}  // namespace af2::geometry
