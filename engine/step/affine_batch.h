// Affine points of a rule, evaluated together.
// Not installed.
#pragma once

#include <vector>

#include "engine/base/point.h"
#include "engine/rule/point_transform.h"

namespace af2 {

/// Up to eight affine points of a rule, evaluated together: a structure of arrays with one row of
/// coefficients for each matched vertex.
struct AffineBatch {
  static constexpr int kCapacity = 8;
  struct Row {
    double xx[kCapacity]{}, yy[kCapacity]{};
    double xy[kCapacity]{}, yx[kCapacity]{};
  };

  int count = 0;
  bool isMixed = false;  ///< whether any x depends on a y or vice versa
  double constantX[kCapacity]{}, constantY[kCapacity]{};
  std::vector<Row> rows;  ///< by matched vertex from b on: a is the origin

  void add(const AffinePointTransform& transform, int matchedCount);
  /// Slots from `count` on are undefined.
  void evaluate(const Point2* matched, double* x, double* y) const;
  /// Evaluates one of the points.
  Point2 point(int slot, const Point2* matched) const {
    const auto k = static_cast<std::size_t>(slot);
    Point2 sum{constantX[k], constantY[k]};
    for (const Row& row : rows) {
      const Point2 p = *++matched;
      sum.x += row.xx[k] * p.x + row.xy[k] * p.y;
      sum.y += row.yx[k] * p.x + row.yy[k] * p.y;
    }
    return sum;
  }
};

}  // namespace af2
