// Sparse systems of linear equations that are not symmetric.
// Not installed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

struct SparseEntry {
  std::uint32_t row = 0, column = 0;
  double value = 0;
};

/// The solution for two right-hand sides at once, x and y; none if the matrix is singular.
///
/// matrix  entries at the same place are summed
std::optional<std::vector<Point2>> solveSparse(const std::vector<SparseEntry>& matrix,
                                               const std::vector<Point2>& right);

}  // namespace af2::geometry
