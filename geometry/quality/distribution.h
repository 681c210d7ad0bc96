// A list of values in a few numbers.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/export.h"

namespace af2::geometry {

/// Percentiles are interpolated linearly between neighbours. All zero if there are no values.
struct Distribution {
  std::size_t count = 0;
  double min = 0, p1 = 0, p5 = 0, median = 0, mean = 0, p95 = 0, p99 = 0, max = 0;
  bool operator==(const Distribution&) const = default;
};

AF2_EXPORT Distribution distributionOf(std::vector<double> values);

}  // namespace af2::geometry
