// Proofs over all matches of an affine rule.
#pragma once

#include "engine/rule_set.h"

namespace af2::dsl {

/// Whether it is proven that no element turns over, at any match at this level whose zone is convex
/// and whose base is 0.7 to 1.4 times the wanted length. False: not proven, not disproven.
///
/// First by writing corners as combinations of zone corners; where that does not do, by interval
/// branch and bound over the tolerance ellipses. Bounds allow for rounding of 1e-9.
bool provesPositive(const RuleSet& rules, const AF2Rule& rule, int level);

/// Whether it is proven that every element lies in the zone, at any such match.
bool provesCovered(const RuleSet& rules, const AF2Rule& rule, int level);

}  // namespace af2::dsl
