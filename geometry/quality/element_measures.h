// Measures of single elements: scaled Jacobian, aspect ratio, angles.
#pragma once

#include <array>
#include <span>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2::geometry {

/// The corners of an element in space, counter-clockwise: three or four.
using CornerPoints = std::span<const Point3>;

/// The normal of an element, times twice its area: of a quadrilateral, the product of its
/// diagonals.
AF2_EXPORT Point3 areaVector(CornerPoints corners);

/// 1 for the equilateral triangle and for every rectangle, 0 for a degenerate element, negative for
/// a quadrilateral with a corner that turns against its normal. Source: [Stimpson07].
///
/// Quadrilateral: the least value of (p x q) . n / (|p| |q|) over the corners, with p and q the
/// sides to the next and to the previous corner and n the unit normal of the element. Triangle:
/// 2 / sqrt(3) |p x q| / (the largest product of the lengths of two sides).
AF2_EXPORT double scaledJacobian(CornerPoints corners);

/// 1 for the equilateral triangle and the square; a rectangle of 1 : 2 has 1.5. Infinite for an
/// element without area. Source: [Stimpson07].
///
/// The longest side times the sum of the sides, over 4 sqrt(3) area (triangle) or 4 area
/// (quadrilateral).
AF2_EXPORT double aspectRatio(CornerPoints corners);

/// The angle between the sides at corner `i`, in degrees from 0 to 360. The corner of a
/// quadrilateral that turns against its normal has more than 180 degrees.
AF2_EXPORT double cornerAngle(CornerPoints corners, std::size_t i);

}  // namespace af2::geometry
