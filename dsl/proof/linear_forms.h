// Points as affine sums, and what follows from a zone's being convex.
#pragma once

#include <map>
#include <vector>

#include "dsl/program/program.h"

namespace af2::dsl {

/// constant + sum of coefficient * node. The nodes are coordinates of the match, or stand for
/// whatever is no affine sum itself; coefficients are never zero.
struct LinearForm {
  double constant = 0;
  std::map<Node, double> terms;
};

LinearForm sumOf(double s, const LinearForm& p, double t, const LinearForm& q);

struct LinearPoint {
  LinearForm x, y;
};

/// A point as sum of weights * corners, weights >= 0 that add up to 1, whatever the match.
using Weights = std::vector<double>;  ///< by corner

/// All ways to write a point so with at most three corners. If there is one, the point lies in
/// their convex hull at every match.
std::vector<Weights> convexCombinations(const LinearPoint& point,
                                        const std::vector<LinearPoint>& corners);

/// Whether three points turn left at nearly all matches for which the zone is convex, and nowhere
/// right: shown by writing them as combinations of its corners. Their turn is then a sum of turns
/// of corners, and those of corners in order are never right turns.
bool turnLeftInConvex(const LinearPoint& p, const LinearPoint& q, const LinearPoint& r,
                      const std::vector<LinearPoint>& zone);

}  // namespace af2::dsl
