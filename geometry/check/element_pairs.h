// Pairs of elements of two trees that cross or overlap.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/check/element_crossings.h"
#include "geometry/check/element_tree.h"
#include "geometry/check/patch_outline.h"

namespace af2::geometry {

/// Elements that reach into each other by less than this share of the mesh's diagonal touch: its
/// points are no more exact, nor are the models.
inline constexpr double kDepth = 1e-9;

/// Adds the pairs of elements of which one is in each tree. If a tree is compared with itself, each
/// pair is added once; but a quadrilateral may be added with both its halves.
///
/// depth  elements that reach into each other by less than this touch
void addCrossings(const ModelMesh& mesh, const ElementTree& one, const ElementTree& other,
                  double depth, std::vector<Crossing>& found);

/// Puts pairs in the order of their elements, each once.
void sortCrossings(std::vector<Crossing>& crossings);

/// Pairs of boxes that are nearer to each other than twice `depth`, each once, the lower index
/// first.
///
/// isAsked(i, k)  whether to look at this pair; also called for i = k
template <class IsAsked>
std::vector<std::pair<std::size_t, std::size_t>> nearPairs(std::vector<Box3> boxes, double depth,
                                                           const IsAsked& isAsked) {
  for (Box3& box : boxes) box = ElementTree::grown(box, depth);
  const BoxTree tree(boxes);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (isAsked(i, i)) pairs.emplace_back(i, i);
    tree.forEachIn(boxes[i], [&](std::size_t k) {
      if (k > i && isAsked(i, k)) pairs.emplace_back(i, k);
    });
  }
  return pairs;
}

/// Around all boxes; the measure of depths.
double depthFor(const std::vector<Box3>& boxes);

}  // namespace af2::geometry
