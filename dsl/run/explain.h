// Why each rule was or was not applied at a base edge, with numbers and the level at which it would
// be, for `af2 explain` and for failed tests.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/rule/refusal.h"
#include "engine/rule/rule_set.h"
#include "engine/step/single_step.h"

namespace af2::dsl {

/// What came of one rule.
struct RuleExplanation {
  std::string rule;  ///< its title
  std::size_t matches = 0;
  Refusal reason = Refusal::None;  ///< None: it was applied
  std::string because;             ///< the numbers behind the reason; may be empty
  std::optional<double> score;
  /// The lowest higher quality level at which the rule itself would not be refused there, if that
  /// was searched for and there is one.
  std::optional<int> passesAtLevel;
};

struct StepExplanation {
  int level = 1, maxLevel = 1;
  std::optional<std::size_t> applied;  ///< index of the rule
  std::vector<RuleExplanation> rules;  ///< in the order of the rule set
  SingleStep step;                     ///< what was applied, and the matches that were refused
};

/// Takes the step and explains each rule.
///
/// names         of the vertices of the piece
/// higherLevels  whether to search for the level at which a refused rule would pass
///
/// Throws InputError if the piece is not a front.
AF2_EXPORT StepExplanation explainStep(const RuleSet& rules, SingleStepper& stepper,
                                       const FrontPiece& piece,
                                       const std::vector<std::string>& names, bool higherLevels);

/// A table with a line for each rule that was tried at this level, and below it the most frequent
/// cause with a remedy, if no rule was applied. The lines begin with `indent`.
///
/// only  title of one rule to show, or empty: all
AF2_EXPORT std::string toText(const StepExplanation& explanation, const std::string& indent = {},
                              const std::string& only = {});
AF2_EXPORT std::string toJson(const StepExplanation& explanation);

/// The reason that most rules share, `Pattern` only if there is no other; null if no rule was
/// tried.
AF2_EXPORT std::optional<Refusal> mainCause(const std::vector<Refusal>& reasons);
/// "zone hit by vertex; vertex p2 at (0.5, 0.9) lies in the zone; passes at level 3"
AF2_EXPORT std::string toText(const RuleExplanation& rule);

/// What an author can do about a reason for a refusal.
AF2_EXPORT const char* remedyFor(Refusal reason);

}  // namespace af2::dsl
