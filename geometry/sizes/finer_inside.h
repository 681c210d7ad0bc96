// How many elements sizes by position may want inside a face. Not installed.
#pragma once

#include <algorithm>
#include <span>

#include "geometry/sizes/growing_size.h"
#include "geometry/sizes/sizes.h"

namespace af2::geometry {

/// An upper bound of the elements that a front may make where sizes inside a face may be much
/// smaller than its boundary and its own size tell. The default is for sizes that are not.
struct FinerInside {
  /// Times as many as are expected, if the smallest size of a box or a field is that of the whole
  /// face.
  double share = 1;
  /// Around points, if these are far from each other; and times as many as are expected, if the
  /// smallest size at a point is that of the whole face. The smaller number counts.
  double around = 0, shareAtPoints = 0;

  double most(double expected) const {
    return share * expected + std::min(around, shareAtPoints * expected);
  }
  /// Both kinds of sizes apply.
  FinerInside operator+(const FinerInside& other) const {
    return {share + other.share - 1, around + other.around,
            std::max(shareAtPoints, other.shareAtPoints)};
  }
};

/// For sizes that may be anything.
inline constexpr FinerInside kAnySizes{1e5};

/// For the points, boxes, fields and the function of the request. Sizes on faces and edges,
/// curvature and narrow places do not count.
FinerInside finerInside(const Sizes& sizes);

/// For points away from which sizes grow.
///
/// growth   > 0, as in `Sizes`
/// largest  the size that is wanted elsewhere
/// least    no size is smaller
FinerInside finerAround(std::span<const SizeSource> points, double growth, double largest,
                        double least = 0);

}  // namespace af2::geometry
