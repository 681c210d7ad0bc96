// Places the inner vertices of a patch so that its elements get good shapes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "engine/base/point.h"
#include "engine/optimize/quad_patch.h"

namespace af2 {

/// An element with a smaller scaled Jacobian is turned, or nearly so.
inline constexpr double kSoundJacobian = 0.05;

/// Scaled Jacobians of the elements of a patch, each the smallest of its corners but for tips. The
/// smallest one is not positive if an element does not turn left everywhere.
struct PatchJacobians {
  double least = -1, mean = -1;
  /// The number of elements below kSoundJacobian.
  std::size_t turned = std::numeric_limits<std::size_t>::max();

  bool areAtLeast(const PatchJacobians& other) const {
    return least >= other.least && mean >= other.mean && turned <= other.turned;
  }
};

/// What a more regular patch must have to replace one: smoothing at the end can raise the mean
/// again.
inline PatchJacobians acceptableAfter(const PatchJacobians& before) {
  constexpr double kGoodJacobian = 0.8, kMeanMayFall = 0.005;
  return {std::min(kGoodJacobian, before.least), before.mean - kMeanMayFall};
}

/// The least scaled Jacobian of an element at its corners but for tips.
double jacobianOf(const QuadPatch& patch, std::size_t element, const std::vector<Point2>& points);
PatchJacobians jacobiansOf(const QuadPatch& patch, const std::vector<Point2>& points);

/// Moves the inner vertices that elements use, one after another in the order of their numbers, to
/// places where the corners around them are better shaped. Inverted elements are turned round if
/// possible.
///
/// points  by vertex; new vertices begin anywhere near their place
void smoothPatch(const QuadPatch& patch, std::vector<Point2>& points);

}  // namespace af2
