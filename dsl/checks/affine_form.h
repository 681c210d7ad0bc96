// Points of affine rules as affine forms of the match, and what follows from the zone's being
// convex.
#pragma once

#include <optional>
#include <vector>

#include "engine/rule_set.h"

namespace af2::dsl {

/// [0] + [1] v_1 + ... + [n] v_n. The variables of a match are the base's length and then x, y of
/// each further matched vertex.
using Form = std::vector<double>;

struct FormPoint {
  Form x, y;
};

/// An affine rule at a level: everything it places as forms of the match.
struct AffineRule {
  std::size_t variables = 0;
  std::vector<FormPoint> placed;  ///< matched and new vertices
  std::vector<FormPoint> zone;    ///< corners of the convex polygon
};

/// Nothing if a new vertex or the zone is not affine.
std::optional<AffineRule> affineRule(const AF2Rule& rule, int level);

/// A point as sum of weights * zone corners, weights >= 0 that add up to 1, whatever the match.
using Weights = std::vector<double>;  ///< by corner

/// All ways to write a point so with at most three corners. If there is one, the point lies in the
/// zone at every match for which the zone is convex.
std::vector<Weights> convexCombinations(const FormPoint& point, const std::vector<FormPoint>& zone);

/// Whether three points never turn right at matches for which the zone is convex, shown by writing
/// them as combinations of its corners: their turn is then a sum of turns of corners, and those of
/// corners in order are never right turns.
bool neverTurnRight(const FormPoint& p, const FormPoint& q, const FormPoint& r,
                    const std::vector<FormPoint>& zone);

}  // namespace af2::dsl
