// Divides points in space into patches of neighbours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/point.h"

namespace af2::mpi {

/// Points are told apart by planes across the axes, so that the patch of a point needs no memory.
class PatchTree {
 public:
  /// Halves the points, across their longest extent, until no patch has more than `most`. Only
  /// points at one place stay together. Patches are numbered in the order of their first points.
  PatchTree(std::span<const Point3> points, std::size_t most);

  std::size_t count() const { return count_; }
  /// The patch of one of the points.
  std::uint32_t of(const Point3& point) const;

 private:
  static constexpr int kLeaf = -1;
  struct Node {
    double cut = 0;  ///< points below are in the first child, the others in the second
    int axis = kLeaf;
    std::uint32_t next = 0;  ///< the first child, which the second follows; of a leaf: the patch
  };

  std::size_t leafOf(const Point3& point) const;

  std::vector<Node> nodes_;
  std::size_t count_ = 0;
};

}  // namespace af2::mpi
