// A rule with many random matches, which all sampled checks share.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "dsl/match/pattern_match.h"
#include "dsl/proof/sampled_checks.h"
#include "engine/step/single_step.h"

namespace af2::dsl {

/// A match that the pattern and `require` accept, with the vertices and zone of the rule.
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

/// The vertices and zone of the rule at a match.
SampledMatch examine(PatternMatch match);

/// Whether all elements of the match have positions and turn left at each corner. The engine
/// refuses other matches, whatever their zone is.
bool hasPositiveElements(const SampledMatch& one);

/// The match with its coordinates rounded to the fewest digits for which `shows` is still true.
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

/// The levels to check: the first level at which the rule's conditions accept a match, some later
/// levels, all levels at which its pattern moves, and the last level at which it is tried or
/// checked. Empty if the rule set never reaches the rule.
std::vector<int> levelsOf(const RuleSet& rules, const AF2Rule& rule);

/// Matches of a rule at a level.
RuleSample sampleRule(const RuleSet& rules, std::size_t rule, int level, int count,
                      std::uint64_t seed);

// ---- the checks; each gives one finding or none ------------------------------------------------

/// G2: every element turns left at each corner.
std::optional<SampledFinding> findInverted(const RuleSample& sample);
/// G2 again, for faults that samples miss: a search from the flattest samples for flatter elements.
std::optional<SampledFinding> searchInverted(const RuleSample& sample);
/// Z1: every element is inside the free zone; otherwise an obstacle inside it could be missed.
std::optional<SampledFinding> findUncovered(const RuleSample& sample);
/// Z2: the share of the matches that are lost because the zone has no valid shape.
double shareOfLost(const RuleSample& sample);
std::optional<SampledFinding> findLost(const RuleSample& sample);
/// Z3: the zone does not grow as the level rises.
std::optional<SampledFinding> findGrowing(const RuleSample& sample);
/// D1: conditions that are true for every match, or for none. `element` is the number of the
/// condition.
std::vector<SampledFinding> findIdleConditions(const RuleSet& rules, std::size_t rule,
                                               const SamplingOptions& options);
/// D3: the rule is chosen in some situation.
std::optional<SampledFinding> findNeverChosen(const RuleSample& sample, SingleStepper& stepper,
                                              const SamplingOptions& options);

}  // namespace af2::dsl
