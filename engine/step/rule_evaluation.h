// Evaluates a rule at a match without the rest of the front. Rule evaluations, tests, checks and
// proofs use it. The front calls the same functions (rule/rule_at_match.h, rule_scoring.h).
#pragma once

#include <optional>
#include <vector>

#include "engine/base/export.h"
#include "engine/rule/rule_at_match.h"
#include "engine/rule/rule_set.h"

namespace af2 {

/// Everything that a rule determines at a match without the rest of the front. It is computed as
/// far as possible even after a refusal.
struct RuleEvaluation {
  /// The first reason for a refusal, in the order in which the front reports reasons: level and
  /// pattern, conditions, values, shape of the free zone, elements, score.
  RefusalCause refused;
  RefusalCause misfit;    ///< Pattern, else None
  RefusalCause required;  ///< Require or NoValue, else None
  std::vector<std::optional<Point2>> newVertices;
  AF2FreeZoneDef::Made zone;
  std::optional<double> score;  ///< present even if the score is not accepted
};

/// `binding` and its surroundings must belong to the match, for a base edge of this length.
AF2_EXPORT RuleEvaluation evaluateMatch(const RuleSet& rules, const AF2Rule& rule,
                                        const AF2Binding& binding);

/// Why the positions do not match the rule: Class, Pattern, Require or NoValue; else None.
AF2_EXPORT RefusalCause refusalOfMatch(const RuleSet& rules, const AF2Rule& rule,
                                       const AF2Binding& binding);

}  // namespace af2
