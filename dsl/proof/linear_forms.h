// Points as affine sums, and conclusions from the convexity of a zone.
#pragma once

#include <map>
#include <vector>

#include "dsl/program/program.h"

namespace af2::dsl {

/// constant + sum of coefficient * node. The nodes are coordinates of the match, or expressions
/// that are not affine; coefficients are never zero.
struct LinearForm {
  double constant = 0;
  std::map<Node, double> terms;
};

LinearForm sumOf(double s, const LinearForm& p, double t, const LinearForm& q);

struct LinearPoint {
  LinearForm x, y;
};

/// A point as a sum of weights * corners at every match; the weights are >= 0 and add up to 1.
using Weights = std::vector<double>;  ///< by corner

/// All ways to write a point with at most three corners. If there is one, the point is in the
/// convex hull of the corners at every match.
std::vector<Weights> convexCombinations(const LinearPoint& point,
                                        const std::vector<LinearPoint>& corners);

/// Whether three points turn left at almost every match with a convex zone, and never right. This
/// is shown by writing them as combinations of the corners of the zone: their orientation is then a
/// sum of orientations of corners, and corners in order never turn right.
bool turnLeftInConvex(const LinearPoint& p, const LinearPoint& q, const LinearPoint& r,
                      const std::vector<LinearPoint>& zone);

}  // namespace af2::dsl
