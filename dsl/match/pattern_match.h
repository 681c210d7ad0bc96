// A rule at given positions of its pattern, with no front around it: what pictures show and what
// sampled checks look at.
#pragma once

#include <optional>
#include <vector>

#include "engine/rule/binding.h"
#include "engine/rule/rule_set.h"
#include "engine/step/single_step.h"

namespace af2::dsl {

class PatternMatch final : public AF2Surroundings {
 public:
  /// vertices  the matched ones in pattern order; [0] and [1] on the x axis
  PatternMatch(const AF2Rule& rule, std::vector<Point2> vertices, int level);
  static PatternMatch atReference(const AF2Rule& rule, int level);

  const AF2Rule& rule() const { return *rule_; }
  const std::vector<Point2>& vertices() const { return vertices_; }
  int level() const { return level_; }
  AF2Binding binding() const { return {vertices_, level_, this}; }

  /// The free angle, where the pattern's chains fix it.
  std::optional<double> turn(int vertex) const override;

  /// Matched and new vertices; nothing where a placement has no value.
  std::optional<std::vector<Point2>> placeAll() const;

  /// Class, Pattern, Require or NoValue: why the match is no match of the rule; else None.
  Refusal refusalOfMatch(const RuleSet& rules) const;

 private:
  const AF2Rule* rule_;
  std::vector<Point2> vertices_;
  int level_;
};

/// The corners of an element, out of PatternMatch::placeAll.
std::vector<Point2> cornersOf(const RuleElement& element, const std::vector<Point2>& placed);

/// The pattern's edges as walks over its vertices, the one with the base edge first; a closed walk
/// ends in the vertex in which it begins.
std::vector<std::vector<int>> chainsOf(const RuleDefinition& rule);

/// The piece of front that a match stands on, and nothing else.
FrontPiece pieceOf(const PatternMatch& match, int level);

}  // namespace af2::dsl
