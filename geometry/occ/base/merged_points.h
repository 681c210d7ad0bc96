// Which of many points are to be one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "geometry/base/box_tree.h"

namespace af2::geometry {

/// Which points were found to be the same.
class MergedPoints {
 public:
  explicit MergedPoints(const std::vector<Point3>& points)
      : parent_(points.size()), boxes_(points.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (std::size_t i = 0; i < points.size(); ++i) boxes_[i].add(points[i]);
  }
  /// The first of those that are the same as this one.
  std::uint32_t find(std::uint32_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void merge(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low = std::min(find(a), find(b)), high = std::max(find(a), find(b));
    boxes_[low].add(boxes_[high]);
    parent_[high] = low;
  }
  /// How far apart the points are that would be one if these two were.
  double extent(std::uint32_t a, std::uint32_t b) const {
    Box3 box = boxes_[find(a)];
    box.add(boxes_[find(b)]);
    return distance(box.low, box.high);
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<Box3> boxes_;  // by root
};

}  // namespace af2::geometry
