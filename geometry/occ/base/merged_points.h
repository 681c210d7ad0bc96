// Keeps track of points that are merged.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/base/box_tree.h"
#include "geometry/base/disjoint_sets.h"

namespace af2::geometry {

/// The groups of points that were merged.
class MergedPoints {
 public:
  explicit MergedPoints(const std::vector<Point3>& points)
      : sets_(points.size()), boxes_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) boxes_[i].add(points[i]);
  }
  /// The first point of the group of this point.
  std::uint32_t find(std::uint32_t i) { return sets_.of(i); }
  void merge(std::uint32_t a, std::uint32_t b) {
    const Box3 box = boxOfBoth(a, b);
    sets_.join(a, b);
    boxes_[find(a)] = box;
  }
  /// The extent of the group that merging these two would create.
  double extent(std::uint32_t a, std::uint32_t b) {
    const Box3 box = boxOfBoth(a, b);
    return distance(box.low, box.high);
  }

 private:
  Box3 boxOfBoth(std::uint32_t a, std::uint32_t b) {
    Box3 box = boxes_[find(a)];
    box.add(boxes_[find(b)]);
    return box;
  }

  DisjointSets sets_;
  std::vector<Box3> boxes_;  // by the first point of each group
};

}  // namespace af2::geometry
