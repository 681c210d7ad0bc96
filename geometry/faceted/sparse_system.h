// Solves sparse systems of linear equations that are not symmetric.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

namespace af2::geometry {

struct SparseEntry {
  std::uint32_t column = 0;
  double value = 0;
};

/// The rows of a matrix with a diagonal that outweighs the rest of each row.
class SparseSystem {
 public:
  /// rows  each with its entries by ascending columns, the diagonal among them
  explicit SparseSystem(std::vector<std::vector<SparseEntry>> rows);

  /// The solution for a right side, as well as rounding allows.
  std::vector<double> solve(const std::vector<double>& right) const;

 private:
  void factorize();
  std::vector<double> times(const std::vector<double>& x) const;
  /// Through the factors, about the solution.
  std::vector<double> roughly(const std::vector<double>& right) const;

  std::vector<std::vector<SparseEntry>> rows_;
  std::vector<std::vector<SparseEntry>> factors_;  // in the places of the matrix alone
  std::vector<double> inverseDiagonal_;            // of the upper factor
};

}  // namespace af2::geometry
