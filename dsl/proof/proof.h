// Proofs over all matches of a rule.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "engine/base/export.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

/// How far a proof may go.
struct ProofEffort {
  std::size_t mostBoxes = 0;  ///< that are looked at, for all levels of one question
  double smallestSide = 0;    ///< boxes are not cut finer
};

inline constexpr ProofEffort kUsualEffort{2000, 1e-3};
inline constexpr ProofEffort kGreatEffort{400'000, 1e-5};

/// Which matches are meant: the base is 0.7 to 1.4 times the wanted length; every other vertex is
/// where its tolerance allows, one that may be anywhere within 2.5 lengths of its reference; the
/// size field is uniform (h is 1); everything else that rules may ask of the front is anything.
///
/// False: not proven, not disproven. `effort` is used up as boxes are looked at. Bounds are rounded
/// outwards; what is shown to be at least -1e-7 counts as not negative.
AF2_EXPORT bool provesPositive(const RuleSet& rules, const AF2Rule& rule, int level,
                               ProofEffort& effort);

/// Whether every element lies in the zone, at any such match with elements that are positive.
AF2_EXPORT bool provesCovered(const RuleSet& rules, const AF2Rule& rule, int level,
                              ProofEffort& effort);

/// Whether a condition is surely `truth` at every match that passes the pattern and the `require`
/// of `rule`, and at which none of `failing` holds: here base edges of any length are meant, and
/// vertices anywhere. Where the condition has no value nothing is said. Neither it nor the rule's
/// `require` may ask for sizes.
AF2_EXPORT bool provesCondition(
    const RuleSet& rules, const AF2Rule& rule, const AF2BindingFunction& condition, bool truth,
    int level, ProofEffort& effort,
    std::span<const std::shared_ptr<const AF2BindingFunction>> failing = {});

}  // namespace af2::dsl
