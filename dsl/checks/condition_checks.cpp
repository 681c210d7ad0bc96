// D1: is there a match that a condition refuses, and one that it lets through?
#include <fmt/format.h>

#include <algorithm>

#include "dsl/checks/match_sampler.h"
#include "dsl/checks/rule_sample.h"
#include "dsl/checks/test_text.h"
#include "dsl/compiled_forms.h"

namespace af2::dsl {
namespace {

using Condition = std::shared_ptr<const AF2BindingFunction>;

const Program* programOf(const Condition& condition) {
  const auto* expression = dynamic_cast<const ExpressionFunction*>(condition.get());
  return expression ? &expression->program() : nullptr;
}

bool has(const Program& program, Op op) {
  return std::ranges::any_of(program.steps(), [&](const Step& step) { return step.op == op; });
}

/// Proofs take the size field for uniform, which it need not be.
bool asksForSizes(const Condition& condition) {
  const Program* program = programOf(condition);
  return !program || has(*program, Op::SizeAt);
}

/// The length of a vector: sums of squares are never negative.
bool isLength(const Program& program, const Step& root) {
  const auto& steps = program.steps();
  const auto at = [&](Node node) -> const Step& { return steps[static_cast<std::size_t>(node)]; };
  const auto isSquare = [&](Node node) {
    const Step& step = at(node);
    return step.op == Op::Multiply && step.arguments[0] == step.arguments[1];
  };
  const Step& sum = at(root.arguments[0]);
  return isSquare(root.arguments[0]) ||
         (sum.op == Op::Add && isSquare(sum.arguments[0]) && isSquare(sum.arguments[1]));
}

/// Whether the condition has a value at every match: where it has none, it refuses.
bool hasAlwaysValue(const Program& program) {
  return std::ranges::all_of(program.steps(), [&](const Step& step) {
    switch (step.op) {
      case Op::Constant:
      case Op::CoordinateX:
      case Op::CoordinateY:
      case Op::Level:
      case Op::Add:
      case Op::Subtract:
      case Op::Multiply:
      case Op::Negate:
      case Op::Less:
      case Op::LessEqual:
      case Op::Equal:
      case Op::And:
      case Op::Or:
      case Op::Not:
      case Op::LeftTurn:
      case Op::NotRightTurn:
        return true;
      case Op::SquareRoot:
        return isLength(program, step);
      default:
        return false;
    }
  });
}

/// How a condition answers for matches that the pattern and the conditions before it let through.
class ConditionCheck {
 public:
  ConditionCheck(const RuleSet& rules, std::size_t index, std::size_t number,
                 const SamplingOptions& options)
      : rules_(rules),
        condition_(rules.rules()[index].definition().requirements[number]),
        before_(upTo(rules.rules()[index].definition(), number)),
        options_(options) {}

  bool alwaysHolds() const {
    const Program* program = programOf(condition_);
    return program && hasAlwaysValue(*program) && isAlways(true);
  }
  bool neverHolds() const { return isAlways(false); }

 private:
  static AF2Rule upTo(RuleDefinition definition, std::size_t number) {
    definition.requirements.resize(number);
    std::erase_if(definition.requirements, asksForSizes);
    return AF2Rule(std::move(definition));
  }

  /// At every level at which the rule is tried.
  bool isAlways(bool truth) const {
    if (asksForSizes(condition_) || !seemsAlways(truth)) return false;
    const RuleDefinition& rule = before_.definition();
    const int last = std::min(rule.lastLevel.value_or(rules_.maxLevel()), rules_.maxLevel());
    ProofEffort effort = options_.effort;
    for (int level = rule.firstLevel; level <= last; ++level)
      if (!provesCondition(rules_, before_, *condition_, truth, level, effort)) return false;
    return true;
  }

  /// Most conditions answer both ways within a few samples: no proof is tried then.
  bool seemsAlways(bool truth) const {
    constexpr int kLooked = 100;
    MatchSampler sampler(rules_, before_, before_.definition().firstLevel, options_.seed);
    for (int i = 0; i < kLooked; ++i) {
      const auto match = sampler.next();
      if (!match) return i > 0;
      const auto value = condition_->evaluate(match->binding());
      if ((value && *value != 0) != truth) return false;
    }
    return true;
  }

  const RuleSet& rules_;
  const Condition condition_;
  const AF2Rule before_;
  const SamplingOptions& options_;
};

SampledFinding idleFinding(const RuleSet& rules, std::size_t index, std::size_t number,
                           bool holds) {
  const AF2Rule& rule = rules.rules()[index];
  const int level = rule.definition().firstLevel;
  const auto reference = PatternMatch::atReference(rule, level);
  SampledFinding finding;
  finding.code = "D1";
  finding.rule = index;
  finding.element = static_cast<int>(number);
  finding.example = {reference.vertices(), level, {}, {}};
  if (holds) {
    finding.message = fmt::format(
        "this condition of rule '{}' always holds: no match that the pattern and the conditions "
        "before it let through fails it",
        rule.name());
    finding.help = "remove it, or compare with what was meant";
    return finding;
  }
  finding.message = fmt::format(
      "this condition never holds, so rule '{}' never applies: no match that the pattern and the "
      "conditions before it let through passes it",
      rule.name());
  finding.help = "compare it with the reference positions and their tolerances";
  finding.test = writeTest(reference, {fmt::format("{}: applies where it fits", rule.name()),
                                       {},
                                       fmt::format("rule \"{}\"", rule.name())});
  return finding;
}

}  // namespace

std::vector<SampledFinding> findIdleConditions(const RuleSet& rules, std::size_t index,
                                               const SamplingOptions& options) {
  std::vector<SampledFinding> findings;
  const std::size_t count = rules.rules()[index].definition().requirements.size();
  for (std::size_t number = 0; number < count; ++number) {
    const ConditionCheck check(rules, index, number, options);
    const bool holds = check.alwaysHolds();
    if (!holds && !check.neverHolds()) continue;
    findings.push_back(idleFinding(rules, index, number, holds));
    if (!holds) break;  // behind it everything holds, for nothing is left
  }
  return findings;
}

}  // namespace af2::dsl
