#include "geometry/faceted/main_directions.h"

#include <cmath>

#include "engine/base/elementary.h"
#include "geometry/faceted/flats.h"

namespace af2::geometry {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix momentsOf(const Facets& facets, const std::vector<std::uint32_t>& triangles) {
  Point3 middle;
  double total = 0;
  for (const std::uint32_t t : triangles) {
    const double area = areaOf(facets, t);
    middle = middle + area * middleOf(facets, t);
    total += area;
  }
  if (total > 0) middle = (1 / total) * middle;
  Matrix moments{};
  for (const std::uint32_t t : triangles) {
    const double area = areaOf(facets, t);
    const Point3 d = middleOf(facets, t) - middle;
    const std::array<double, 3> x{d.x, d.y, d.z};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) moments[i][j] += area * x[i] * x[j];
  }
  return moments;
}

/// Turns two axes so that the matrix has nothing between them.
void rotate(Matrix& a, std::array<Point3, 3>& axes, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + length(Point2{theta, 1}));
  const double c = 1 / length(Point2{t, 1}), s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double kp = a[k][p], kq = a[k][q];
    a[k][p] = c * kp - s * kq;
    a[k][q] = s * kp + c * kq;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double pk = a[p][k], qk = a[q][k];
    a[p][k] = c * pk - s * qk;
    a[q][k] = s * pk + c * qk;
  }
  const Point3 first = axes[p], second = axes[q];
  axes[p] = c * first - s * second;
  axes[q] = s * first + c * second;
}

}  // namespace

std::array<Point3, 3> mainDirections(const Facets& facets,
                                     const std::vector<std::uint32_t>& triangles) {
  constexpr int kSweeps = 12;  // Jacobi's method has long converged
  Matrix moments = momentsOf(facets, triangles);
  std::array<Point3, 3> axes{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rotate(moments, axes, 0, 1);
    rotate(moments, axes, 1, 2);
    rotate(moments, axes, 0, 2);
  }
  return axes;
}

}  // namespace af2::geometry
