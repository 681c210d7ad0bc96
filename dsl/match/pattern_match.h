// A rule at given positions of its pattern, without a front around it, for pictures and checks.
#pragma once

#include <utility>
#include <vector>

#include "engine/rule/rule_at_match.h"
#include "engine/rule/rule_set.h"
#include "engine/step/rule_evaluation.h"
#include "engine/step/single_step.h"

namespace af2::dsl {

class PatternMatch final : public RuleAtMatch {
 public:
  /// vertices  the matched ones in pattern order; [0] and [1] on the x axis
  PatternMatch(const AF2Rule& rule, std::vector<Point2> vertices, int level)
      : RuleAtMatch(rule.definition(), std::move(vertices), level), rule_(&rule) {}
  static PatternMatch atReference(const AF2Rule& rule, int level) {
    return PatternMatch(rule, RuleAtMatch::atReference(rule.definition(), level).vertices(), level);
  }

  const AF2Rule& rule() const { return *rule_; }

  /// The reason why the positions do not match the rule (Class, Pattern, Require or NoValue), or
  /// None.
  Refusal refusalOfMatch(const RuleSet& rules) const {
    return af2::refusalOfMatch(rules, *rule_, binding()).reason;
  }

 private:
  const AF2Rule* rule_;
};

/// The corners of an element, taken from the result of PatternMatch::placeAll.
std::vector<Point2> cornersOf(const RuleElement& element, const std::vector<Point2>& placed);

/// The pattern's edges as walks over its vertices, the one with the base edge first; a closed walk
/// ends in the vertex in which it begins.
std::vector<std::vector<int>> chainsOf(const RuleDefinition& rule);

/// The piece of front of a match, and nothing else.
FrontPiece pieceOf(const PatternMatch& match, int level);

}  // namespace af2::dsl
