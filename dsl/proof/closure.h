// C1, N2: does a rule set that keeps loops even close what it can meet?
#pragma once

#include <optional>
#include <vector>

#include "dsl/proof/sampled_checks.h"
#include "engine/rule/rule_set.h"
#include "engine/step/front_piece.h"

namespace af2::dsl {

/// A base edge whose ends want these numbers of elements, where no rule is accepted at level 1.
struct CountGap {
  int countA = 0, countB = 0;
  FrontPiece piece;
};

/// Small loops, each alone in a plane, that the rule set was run on.
struct Closure {
  std::vector<CountGap> gaps;
  int tried = 0, closed = 0;
  std::vector<Point2> open;  ///< the first loop that did not close with the rules alone
};

/// Tries a base edge with each pair of counts from 1 to 4, and random even loops of 4, 6 and 8
/// edges of about the target size, always the same ones. Nothing unless the set has `parity even`.
std::optional<Closure> measureClosure(const RuleSet& rules);

/// C1 and N2, about no rule in particular.
std::vector<SampledFinding> findingsOf(const Closure& closure);

}  // namespace af2::dsl
