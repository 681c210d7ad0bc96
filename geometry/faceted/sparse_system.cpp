// The same sums in the same order everywhere; nothing but what is under the MPL.
#define EIGEN_DONT_PARALLELIZE
#define EIGEN_DONT_VECTORIZE
#define EIGEN_MPL2_ONLY

#include "geometry/faceted/sparse_system.h"

#include <Eigen/SparseLU>

namespace af2::geometry {

std::optional<std::vector<Point2>> solveSparse(const std::vector<SparseEntry>& matrix,
                                               const std::vector<Point2>& right) {
  if (right.empty()) return std::vector<Point2>();  // Eigen divides by the count
  const auto count = static_cast<Eigen::Index>(right.size());
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(matrix.size());
  for (const auto& [row, column, value] : matrix)
    triplets.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  Eigen::SparseMatrix<double> left(count, count);
  left.setFromTriplets(triplets.begin(), triplets.end());
  Eigen::MatrixX2d sides(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Point2 p = right[static_cast<std::size_t>(i)];
    sides.row(i) << p.x, p.y;
  }
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(left);
  if (factors.info() != Eigen::Success) return std::nullopt;
  const Eigen::MatrixX2d solution = factors.solve(sides);
  std::vector<Point2> points;
  for (Eigen::Index i = 0; i < count; ++i) points.push_back({solution(i, 0), solution(i, 1)});
  return points;
}

}  // namespace af2::geometry
