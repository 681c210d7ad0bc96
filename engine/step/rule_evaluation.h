// A rule at a match without the rest of the front, question by question: what evaluations, tests,
// checks and proofs ask. The front asks the same functions (rule/rule_at_match.h, rule_scoring.h).
#pragma once

#include <optional>
#include <vector>

#include "engine/base/export.h"
#include "engine/rule/rule_at_match.h"
#include "engine/rule/rule_set.h"

namespace af2 {

/// All that can be said about a rule at a match without the rest of the front. What a refusal does
/// not hide is answered behind it, too.
struct RuleEvaluation {
  /// The first reason against the rule, in the order in which the front reports reasons: level and
  /// pattern, conditions, values, the form of the free zone, elements, score.
  RefusalCause refused;
  RefusalCause misfit;    ///< Pattern, else None
  RefusalCause required;  ///< Require or NoValue, else None
  std::vector<std::optional<Point2>> newVertices;
  AF2FreeZoneDef::Made zone;
  std::optional<double> score;  ///< also one that is not accepted
};

/// `binding` and its surroundings must be those of the match, for a base edge of this length.
AF2_EXPORT RuleEvaluation evaluateMatch(const RuleSet& rules, const AF2Rule& rule,
                                        const AF2Binding& binding);

/// Class, Pattern, Require or NoValue: why a match is no match of the rule; else None.
AF2_EXPORT RefusalCause refusalOfMatch(const RuleSet& rules, const AF2Rule& rule,
                                       const AF2Binding& binding);

}  // namespace af2
