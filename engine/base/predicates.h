// Exact orientation and intersection tests for points with double coordinates.
//
// A floating-point filter answers when its error bound proves the sign. Otherwise CGAL's exact
// arithmetic answers (predicates.cpp, the only use of CGAL in the engine).
#pragma once

#include <cmath>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2 {

enum class Turn { Right = -1, Straight = 0, Left = 1 };

namespace detail {
AF2_EXPORT Turn exactOrientation(Point2 a, Point2 b, Point2 c);

/// (3 + 16 eps) eps with eps = 2^-53: bounds the error of the determinant below relative to the sum
/// of the sizes of its two products. Source: [Shewchuk97], ccwerrboundA.
inline constexpr double kOrientationErrorBound = 3.3306690738754716e-16;
/// Below this size the products may have lost bits to underflow, so the bound proves nothing.
inline constexpr double kUnderflowGuard = 1e-290;

/// Whether left - right, for the two products of an orientation, is certainly positive.
inline bool isPlainlyLeft(double left, double right) {
  const double size = std::abs(left) + std::abs(right);
  return (left - right > kOrientationErrorBound * size) & (size > kUnderflowGuard) & (size < 1e300);
}
}  // namespace detail

/// Which way the path a -> b -> c turns. Exact.
inline Turn orientation(Point2 a, Point2 b, Point2 c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double size = std::abs(left) + std::abs(right);
  if (std::abs(det) > detail::kOrientationErrorBound * size && size > detail::kUnderflowGuard &&
      size < 1e300)
    return det > 0 ? Turn::Left : Turn::Right;
  // Both products are zero if a difference in each is zero. This is common: for edges that share a
  // vertex with a zone and for rows of vertices along an axis. Exact arithmetic would be slow.
  const bool leftVanishes = a.x == c.x || b.y == c.y, rightVanishes = a.y == c.y || b.x == c.x;
  if ((leftVanishes && rightVanishes) || a == b) return Turn::Straight;
  return detail::exactOrientation(a, b, c);
}

/// Whether the closed segments pq and rs have a point in common. Exact.
AF2_EXPORT bool segmentsMeet(Point2 p, Point2 q, Point2 r, Point2 s);

}  // namespace af2
