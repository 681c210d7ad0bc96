// A rule with many of its matches, drawn once for all sampled checks.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "dsl/match/pattern_match.h"
#include "dsl/proof/sampled_checks.h"
#include "engine/step/single_step.h"

namespace af2::dsl {

/// A match that passes pattern and `require`, and what the rule makes of it.
struct SampledMatch {
  PatternMatch match;
  double deviation = 0;                       ///< from the reference
  std::optional<std::vector<Point2>> placed;  ///< all vertices; none: NoValue
  std::shared_ptr<const AF2FreeZone> zone;    ///< null: refused
  Refusal zoneRefusal = Refusal::None;
};

struct RuleSample {
  const RuleSet& rules;
  std::size_t index;
  const AF2Rule& rule;
  int level;
  std::vector<SampledMatch> matches;

  const std::string& name() const { return rule.name(); }
};

/// The match with coordinates that are multiples of `step`.
PatternMatch roundedTo(const PatternMatch& match, double step);

/// What the rule makes of a match.
SampledMatch examine(PatternMatch match);

/// The match with coordinates of as few digits as still show what `shows` tells of it.
template <class Shows>
SampledMatch simplified(const SampledMatch& one, const RuleSet& rules, const Shows& shows) {
  for (double step = 0.1; step > 1e-6; step *= 0.1) {
    PatternMatch rounded = roundedTo(one.match, step);
    if (rounded.refusalOfMatch(rules) != Refusal::None) continue;
    SampledMatch candidate = examine(std::move(rounded));
    if (shows(candidate)) return candidate;
  }
  return one;
}

/// A finding about the rule, still without message and example.
SampledFinding findingAbout(const RuleSample& sample, Code code);

/// The first level that the rule's conditions let through, some later ones with all at which its
/// pattern moves, and the last one at which it is tried or which is looked at; empty if the rule
/// set never reaches the rule.
std::vector<int> levelsOf(const RuleSet& rules, const AF2Rule& rule);

/// Matches of a rule at a level.
RuleSample sampleRule(const RuleSet& rules, std::size_t rule, int level, int count,
                      std::uint64_t seed);

// ---- the checks; each gives one finding or none ------------------------------------------------

/// G2: every element turns left at each corner.
std::optional<SampledFinding> findInverted(const RuleSample& sample);
/// G2 again, for faults that hide from samples: from the flattest of them on to flatter ones.
std::optional<SampledFinding> searchInverted(const RuleSample& sample);
/// Z1: every element lies in the free zone, or an obstacle inside it would not be seen.
std::optional<SampledFinding> findUncovered(const RuleSample& sample);
/// Z2: share of the matches for which the zone has no valid shape.
double shareOfLost(const RuleSample& sample);
std::optional<SampledFinding> findLost(const RuleSample& sample);
/// Z3: the zone does not grow as the level rises.
std::optional<SampledFinding> findGrowing(const RuleSample& sample);
/// D1: conditions that every match passes, or none. `element` is the number of the condition.
std::vector<SampledFinding> findIdleConditions(const RuleSet& rules, std::size_t rule,
                                               const SamplingOptions& options);
/// D3: there are situations in which the rule is chosen.
std::optional<SampledFinding> findNeverChosen(const RuleSample& sample, SingleStepper& stepper,
                                              const SamplingOptions& options);

}  // namespace af2::dsl
