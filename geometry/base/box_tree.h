// Finds which of many boxes in space meet another one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

struct Box3 {
  Point3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void add(const Point3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void add(const Box3& box) {
    add(box.low);
    add(box.high);
  }
  bool meets(const Box3& other) const {
    // Without branches, because the processor cannot predict which of these tests fails.
    return (low.x <= other.high.x) & (other.low.x <= high.x) & (low.y <= other.high.y) &
           (other.low.y <= high.y) & (low.z <= other.high.z) & (other.low.z <= high.z);
  }
  /// Zero inside.
  double distanceTo(const Point3& p) const { return std::sqrt(squaredDistanceTo(p)); }
  double squaredDistanceTo(const Point3& p) const {
    const auto beyond = [](double value, double from, double to) {
      return std::max(std::max(from - value, value - to), 0.0);
    };
    const Point3 d{beyond(p.x, low.x, high.x), beyond(p.y, low.y, high.y),
                   beyond(p.z, low.z, high.z)};
    return dot(d, d);
  }
};

/// A straight segment, tested for intersection with boxes.
class Segment3 {
 public:
  Segment3(const Point3& from, const Point3& to);
  /// Whether it meets a box. May also be true if it passes so near that rounding cannot decide.
  bool meets(const Box3& box) const;

 private:
  Point3 middle_, half_;  ///< it runs from middle - half to middle + half
  Point3 reach_;          ///< half the sides of the box around it
};

/// A tree of boxes. It is immutable, so threads may share it.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box3>& boxes);

  /// Calls visit(index) for each box that meets `where`, in an order that depends on the boxes
  /// alone.
  ///
  /// Where  Box3 or Segment3
  template <class Where = Box3, class Visit>
  void forEachIn(const Where& where, Visit&& visit) const {
    if (!nodes_.empty()) walk(0, 0, order_.size(), where, visit);
  }

  /// The smallest value of distance(index) over all boxes, and its index; ties go to the lower
  /// index. The distance to the content of a box must not be smaller than the distance to the box.
  /// The index is kNone if nothing is within `farthest`.
  template <class Distance>
  std::uint32_t nearest(const Point3& p, double farthest, Distance&& distance) const {
    Nearest best(farthest, kNone);
    if (!nodes_.empty()) seek(0, 0, order_.size(), p, distance, best);
    return best.index;
  }
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// The lowest index of a box that contains p and that `accepts(index)`; kNone if there is none.
  template <class Accepts>
  std::uint32_t firstAt(const Point3& p, Accepts&& accepts) const {
    std::uint32_t first = kNone;
    forEachIn(Box3{p, p}, [&](std::uint32_t i) {
      if (i < first && accepts(i)) first = i;
    });
    return first;
  }

 private:
  static constexpr std::size_t kLeaf = 4;
  struct Nearest {
    double distance;
    std::uint32_t index;
    double farthest = 0;  ///< square, with a margin for rounding: of boxes that may be nearer

    Nearest(double d, std::uint32_t i) : distance(d), index(i), farthest(d * d * (1 + 1e-12)) {}
  };
  void build(const std::vector<Box3>& boxes, std::size_t node, std::size_t first, std::size_t last);
  static std::size_t middle(std::size_t first, std::size_t last) {
    return first + (last - first) / 2;
  }

  template <class Where, class Visit>
  void walk(std::size_t node, std::size_t first, std::size_t last, const Where& where,
            Visit& visit) const {
    if (!where.meets(nodes_[node])) return;
    if (last - first <= kLeaf) {
      for (std::size_t i = first; i < last; ++i)
        if (where.meets(leaves_[i])) visit(order_[i]);
      return;
    }
    const std::size_t half = middle(first, last);
    walk(2 * node + 1, first, half, where, visit);
    walk(2 * node + 2, half, last, where, visit);
  }

  template <class Distance>
  void seek(std::size_t node, std::size_t first, std::size_t last, const Point3& p,
            Distance& distance, Nearest& best) const {
    if (last - first <= kLeaf) {
      for (std::size_t i = first; i < last; ++i) {
        if (leaves_[i].squaredDistanceTo(p) > best.farthest) continue;
        const double d = distance(order_[i]);
        if (d < best.distance || (d == best.distance && order_[i] < best.index))
          best = Nearest(d, order_[i]);
      }
      return;
    }
    const std::size_t half = middle(first, last), left = 2 * node + 1, right = left + 1;
    const double toLeft = nodes_[left].squaredDistanceTo(p);
    const double toRight = nodes_[right].squaredDistanceTo(p);
    const bool leftFirst = toLeft <= toRight;
    if (leftFirst && toLeft <= best.farthest) seek(left, first, half, p, distance, best);
    if (toRight <= best.farthest) seek(right, half, last, p, distance, best);
    if (!leftFirst && toLeft <= best.farthest) seek(left, first, half, p, distance, best);
  }

  std::vector<Box3> nodes_;           ///< a heap: the halves of node i are 2 i + 1 and 2 i + 2
  std::vector<std::uint32_t> order_;  ///< indices of the boxes, in the order of the leaves
  std::vector<Box3> leaves_;          ///< in this order
};

}  // namespace af2::geometry
