// Proofs over all matches of a rule.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "engine/base/export.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

/// Limits of the effort of a proof.
struct ProofEffort {
  std::size_t mostBoxes = 0;  ///< number of boxes, for all levels of one question
  double smallestSide = 0;    ///< smaller boxes are not split
};

inline constexpr ProofEffort kUsualEffort{2000, 1e-3};
inline constexpr ProofEffort kGreatEffort{400'000, 1e-5};

/// Considers these matches: the base edge has 0.7 to 1.4 times the target size; every other vertex
/// is within its tolerance, or within 2.5 lengths of its reference if it has none; one that is
/// sought by `near` is within reach of its place, and at most 10 lengths from that of its usual
/// match; the size field is uniform (h is 1); all other properties of the front may have any value.
///
/// False means "not proven", not "disproven". Each box reduces `effort`. Bounds are rounded
/// outwards; a value of at least -1e-7 counts as non-negative.
AF2_EXPORT bool provesPositive(const RuleSet& rules, const AF2Rule& rule, int level,
                               ProofEffort& effort);

/// Whether every element is inside the zone, at every such match with positive elements.
AF2_EXPORT bool provesCovered(const RuleSet& rules, const AF2Rule& rule, int level,
                              ProofEffort& effort);

/// Whether a condition is proven to be `truth` at every match that the pattern and the `require` of
/// `rule` accept and at which none of `failing` holds. This considers base edges of any length, and
/// vertices anywhere. Matches at which the condition has no value are not considered. Neither the
/// condition nor the `require` of the rule may depend on sizes.
AF2_EXPORT bool provesCondition(
    const RuleSet& rules, const AF2Rule& rule, const AF2BindingFunction& condition, bool truth,
    int level, ProofEffort& effort,
    std::span<const std::shared_ptr<const AF2BindingFunction>> failing = {});

}  // namespace af2::dsl
