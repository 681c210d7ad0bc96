// Which of many points are to be one.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/base/box_tree.h"
#include "geometry/base/disjoint_sets.h"

namespace af2::geometry {

/// Which points were found to be the same.
class MergedPoints {
 public:
  explicit MergedPoints(const std::vector<Point3>& points)
      : sets_(points.size()), boxes_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) boxes_[i].add(points[i]);
  }
  /// The first of those that are the same as this one.
  std::uint32_t find(std::uint32_t i) { return sets_.of(i); }
  void merge(std::uint32_t a, std::uint32_t b) {
    const Box3 box = boxOfBoth(a, b);
    sets_.join(a, b);
    boxes_[find(a)] = box;
  }
  /// How far apart the points are that would be one if these two were.
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
  std::vector<Box3> boxes_;  // by the point that stands for the others
};

}  // namespace af2::geometry
