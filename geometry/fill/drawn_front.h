// A front in a plane, which is closed by hand. Not installed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/point.h"

namespace af2::geometry {

struct DrawnEdge {
  VertexId from, to;
  auto operator<=>(const DrawnEdge&) const = default;
};

/// The edges of a front in the plane. What is near something is found along the direction in which
/// the front is longest: fronts that have to be closed are mostly narrow strips.
class DrawnFront {
 public:
  /// Of the vertices of edges that are added later on.
  struct Vertex {
    VertexId id;
    Point2 place;
  };
  explicit DrawnFront(std::vector<Vertex> vertices);

  bool isEmpty() const { return byLength_.empty(); }
  bool has(DrawnEdge edge) const { return index_.contains(edge); }
  DrawnEdge edge(std::size_t i) const { return edges_[i].edge; }
  Point2 from(std::size_t i) const { return edges_[i].from; }
  Point2 to(std::size_t i) const { return edges_[i].to; }
  std::size_t shortest() const { return index_.at(byLength_.begin()->second); }

  /// Edges are numbered in the order in which they are added.
  void add(DrawnEdge edge);
  /// Returns whether the edge was there.
  bool takeOut(DrawnEdge edge);

  double along(Point2 p) const { return isLongInX_ ? p.x : p.y; }
  double across(Point2 p) const { return isLongInX_ ? p.y : p.x; }
  /// How far across the front its vertices are at most from a place.
  double farthestAcross(Point2 place) const {
    return std::max(across(high_) - across(place), across(place) - across(low_));
  }

  /// Consecutive vertices along the front.
  struct Stretch {
    std::size_t begin = 0, end = 0;
  };
  /// At most `reach` away from a place along the front.
  Stretch stretchAt(Point2 place, double reach) const {
    return stretchBetween(along(place) - reach, along(place) + reach);
  }
  bool isAll(const Stretch& stretch) const {
    return stretch.begin == 0 && stretch.end == positions_.size();
  }
  /// Calls visit(i) for the edges that start there until it returns false. Returns whether none
  /// did.
  template <class Visit>
  bool forEachFrom(const Stretch& stretch, const Visit& visit) const {
    for (std::size_t at = stretch.begin; at < stretch.end; ++at)
      for (std::uint32_t i = firstAt_[at]; i != kNone; i = edges_[i].next)
        if (!visit(std::size_t{i})) return false;
    return true;
  }
  /// The same for the edges whose boxes meet that of a triangle.
  template <class Visit>
  bool forEachNear(Point2 a, Point2 b, Point2 c, Visit&& visit) const {
    const Point2 low{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
    const Point2 high{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
    const auto visitNear = [&](std::size_t i) {
      const Point2 p = edges_[i].from, q = edges_[i].to;
      const bool isApart = std::max(p.x, q.x) < low.x || std::min(p.x, q.x) > high.x ||
                           std::max(p.y, q.y) < low.y || std::min(p.y, q.y) > high.y;
      return isApart || visit(i);
    };
    return forEachFrom(stretchBetween(along(low) - longest_, along(high) + longest_), visitNear);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Entry {
    DrawnEdge edge;
    Point2 from, to;
    std::uint32_t next;  // of those that start at the same vertex
  };

  Stretch stretchBetween(double low, double high) const {
    const auto place = [&](Point2 p) { return along(p); };
    const auto begin = std::ranges::lower_bound(positions_, low, {}, place);
    const auto end = std::ranges::upper_bound(begin, positions_.end(), high, {}, place);
    return {static_cast<std::size_t>(begin - positions_.begin()),
            static_cast<std::size_t>(end - positions_.begin())};
  }

  Point2 low_, high_;  // of the box around the vertices
  bool isLongInX_ = true;
  std::vector<Point2> positions_;       // of the vertices, in the order along the front
  std::vector<std::uint32_t> firstAt_;  // likewise: an edge that starts there
  std::map<VertexId, std::size_t> ranks_;
  std::vector<Entry> edges_;  // with those that were taken out
  double longest_ = 0;        // edge, along the front
  std::map<DrawnEdge, std::uint32_t> index_;
  std::set<std::pair<double, DrawnEdge>> byLength_;
};

}  // namespace af2::geometry
