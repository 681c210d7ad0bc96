// A tree of boxes over the elements of a face. Not installed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/base/box_tree.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// A tree over some elements, or none. Leaves hold elements that are consecutive on a space-filling
/// curve. Elements that were made one after the other may be far apart, as on both sides of a
/// strip; if leaves held these, the boxes of a strip that is not along an axis would all overlap.
class ElementTree {
 public:
  ElementTree() = default;
  /// elements  of the mesh, counted from `first`
  ElementTree(const ModelMesh& mesh, std::size_t first, const std::vector<std::uint32_t>& elements);

  /// The elements of a leaf.
  struct Run {
    const ElementTree& tree;
    std::size_t first, last;  ///< their places in the order of the tree
    const Box3& box;

    std::size_t element(std::size_t place) const { return tree.first_ + tree.order_[place]; }
  };

  /// Calls visit(run, otherRun) for each pair of runs of this tree and of the other whose boxes are
  /// nearer to each other than `gap`. If a tree is compared with itself, each pair is visited once.
  template <class Visit>
  void forEachNear(const ElementTree& other, double gap, const Visit& visit) const {
    if (count_ == 0 || other.count_ == 0) return;
    walk({levels_.size() - 1, 0}, other, {other.levels_.size() - 1, 0}, gap, visit);
  }

  /// Calls isFree(first, count, places) for large parts of the tree and then, where it returned
  /// false, for smaller parts; the arguments are as in MeshPart. Where it returns true, elements
  /// are not compared with each other when the tree is compared with itself.
  template <class IsFree>
  void findFree(const IsFree& isFree) {
    isFree_.resize(levels_.size());
    for (std::size_t level = kMinFree; level < levels_.size(); ++level)
      isFree_[level].assign(levels_[level].size(), 0);
    if (levels_.size() > kMinFree) findFree({levels_.size() - 1, 0}, isFree);
  }

  static Box3 grown(Box3 box, double gap) {
    box.low = box.low - Point3{gap, gap, gap};
    box.high = box.high + Point3{gap, gap, gap};
    return box;
  }

 private:
  static constexpr std::size_t kRun = 8, kBranches = 4;
  static constexpr std::size_t kMinFree = 3;  ///< level of the smallest parts that may be free
  struct Node {
    std::size_t level, index;
  };

  template <class IsFree>
  void findFree(Node node, const IsFree& isFree) {
    const std::size_t size = kRun << 2 * node.level, first = node.index * size;
    if (isFree(first_, std::min(size, count_ - first), order_.data() + first)) {
      isFree_[node.level][node.index] = 1;
    } else if (node.level > kMinFree) {
      const auto [begin, end] = children(node);
      for (std::size_t i = begin; i < end; ++i) findFree({node.level - 1, i}, isFree);
    }
  }
  bool isFree(Node node) const {
    return node.level < isFree_.size() && !isFree_[node.level].empty() &&
           isFree_[node.level][node.index];
  }

  template <class Visit>
  void walk(Node own, const ElementTree& other, Node its, double gap, const Visit& visit) const {
    if (own.level == 0 && its.level == 0) return visit(run(own.index), other.run(its.index));
    // The larger node is split; if a tree is compared with itself, both are split at once.
    const bool isSelf = this == &other;
    if (isSelf && own.index == its.index && isFree(own)) return;
    const bool takeOwn = own.level >= its.level, takeIts = isSelf || !takeOwn;
    const auto [ownFirst, ownLast] = takeOwn ? children(own) : std::pair(own.index, own.index + 1);
    const auto [itsFirst, itsLast] =
        takeIts ? other.children(its) : std::pair(its.index, its.index + 1);
    const std::size_t ownLevel = own.level - takeOwn, itsLevel = its.level - takeIts;
    for (std::size_t i = ownFirst; i < ownLast; ++i) {
      const Box3 box = grown(levels_[ownLevel][i], gap);
      const bool isSame = isSelf && own.index == its.index;
      for (std::size_t k = isSame ? i : itsFirst; k < itsLast; ++k)
        if (box.meets(other.levels_[itsLevel][k]))
          walk({ownLevel, i}, other, {itsLevel, k}, gap, visit);
    }
  }

  Run run(std::size_t index) const {
    const std::size_t begin = index * kRun;
    return {*this, begin, std::min(begin + kRun, count_), levels_[0][index]};
  }
  std::pair<std::size_t, std::size_t> children(Node node) const {
    const std::size_t begin = node.index * kBranches;
    return {begin, std::min(begin + kBranches, levels_[node.level - 1].size())};
  }

  std::size_t first_ = 0, count_ = 0;
  std::vector<std::uint32_t> order_;       ///< elements, counted from first_
  std::vector<std::vector<Box3>> levels_;  ///< [0]: boxes of the leaves; each further level: boxes
                                           ///< around pairs of the level before
  std::vector<std::vector<std::uint8_t>> isFree_;  ///< by level and node; empty: none is
};

}  // namespace af2::geometry
