// A rule set with one rule changed or added: what the way out of a finding would make of it. With
// it the checks make sure that the tests they hand out pass once that way is taken.
#pragma once

#include <cstddef>
#include <memory>

#include "engine/rule/rule_set.h"
#include "engine/step/single_step.h"

namespace af2::dsl {

class ChangedRules {
 public:
  /// Another rule in place of that one.
  static ChangedRules replacing(const RuleSet& rules, std::size_t rule, RuleDefinition by);
  /// A further rule right behind that one, as a mirror image is.
  static ChangedRules adding(const RuleSet& rules, std::size_t behind, RuleDefinition further);

  const RuleSet& rules() const { return *rules_; }
  SingleStepper& stepper() { return *stepper_; }
  /// Of the rule that is new.
  std::size_t index() const { return index_; }
  /// Whether the new rule is the one that is applied there.
  bool chooses(const FrontPiece& piece) { return stepper_->chosenRule(piece) == index_; }

 private:
  ChangedRules(RuleSetDefinition definition, std::size_t index);

  std::unique_ptr<const RuleSet> rules_;
  std::unique_ptr<SingleStepper> stepper_;
  std::size_t index_;
};

/// The same rule, at a cost so low that it wins and is accepted wherever it applies.
RuleDefinition atLowCost(RuleDefinition rule);

/// The same rule with the zone of a level at all later ones, as if it did not grow.
RuleDefinition withZoneKept(RuleDefinition rule, int level);

/// The same rule with a list of corners that is not convex as a path, which need not be.
RuleDefinition withPathAsZone(RuleDefinition rule);

}  // namespace af2::dsl
