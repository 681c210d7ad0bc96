// D1: does each condition (`require`, or `when` of a zone) refuse some match and accept some match?
#include <fmt/format.h>

#include <algorithm>

#include "dsl/match/match_sampler.h"
#include "dsl/program/compiled_forms.h"
#include "dsl/program/shape_program.h"
#include "dsl/proof/changed_rules.h"
#include "dsl/proof/rule_sample.h"
#include "dsl/proof/test_text.h"

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

/// Whether the condition depends on sizes. Proofs assume a uniform size field, so they say nothing
/// about such conditions.
bool asksForSizes(const Condition& condition) {
  const Program* program = programOf(condition);
  return !program || has(*program, Op::SizeAt) || has(*program, Op::SizeOf);
}

/// Whether a square root is the length of a vector: its argument, a sum of squares, is never
/// negative.
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

/// Whether the condition has a value at every match. Without a value it refuses the match.
bool hasAlwaysValue(const Program& program) {
  return std::ranges::all_of(program.steps(), [&](const Step& step) {
    return step.op == Op::SquareRoot ? isLength(program, step) : operationOf(step.op).isTotal;
  });
}

bool holds(const Condition& condition, const PatternMatch& match) {
  const auto value = condition->evaluate(match.binding());
  return value && *value != 0;
}

/// The values of a condition for matches that the pattern and the earlier conditions accept.
class ConditionCheck {
 public:
  /// condition  a `require` of the rule, or the `when` of a zone
  /// before     the number of `require` conditions before it failing    the `when` of the zones
  /// before it: none of them holds where the condition is evaluated
  ConditionCheck(const RuleSet& rules, const AF2Rule& rule, Condition condition, std::size_t before,
                 std::vector<Condition> failing, const SamplingOptions& options)
      : rules_(rules),
        condition_(std::move(condition)),
        failing_(std::move(failing)),
        before_(upTo(rule.definition(), before)),
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

  /// For every level at which the rule is tried.
  bool isAlways(bool truth) const {
    if (asksForSizes(condition_) || std::ranges::any_of(failing_, asksForSizes) ||
        !seemsAlways(truth))
      return false;
    const RuleDefinition& rule = before_.definition();
    const int last = std::min(rule.lastLevel.value_or(rules_.maxLevel()), rules_.maxLevel());
    ProofEffort effort = options_.effort;
    for (int level = rule.firstLevel; level <= last; ++level)
      if (!provesCondition(rules_, before_, *condition_, truth, level, effort, failing_))
        return false;
    return true;
  }

  /// Most conditions are both true and false within a few samples; then no proof is attempted.
  bool seemsAlways(bool truth) const {
    constexpr int kLooked = 100;
    MatchSampler sampler(rules_, before_, before_.definition().firstLevel, options_.seed);
    bool isAsked = false;
    for (int i = 0; i < kLooked; ++i) {
      const auto match = sampler.next();
      if (!match) break;
      if (std::ranges::any_of(failing_, [&](const Condition& c) { return holds(c, *match); }))
        continue;
      isAsked = true;
      if (holds(condition_, *match) != truth) return false;
    }
    return isAsked;
  }

  const RuleSet& rules_;
  const Condition condition_;
  const std::vector<Condition> failing_;
  const AF2Rule before_;
  const SamplingOptions& options_;
};

SampledFinding idleFinding(const RuleSet& rules, std::size_t index, std::size_t number,
                           bool holds) {
  const AF2Rule& rule = rules.rules()[index];
  const int level = rule.definition().firstLevel;
  const auto reference = PatternMatch::atReference(rule, level);
  SampledFinding finding(Code::IdleClause);
  finding.rule = index;
  finding.element = static_cast<int>(number);
  finding.example = {reference.vertices(), level, {}, {}};
  if (holds) {
    finding.message = fmt::format(
        "this condition of rule '{}' always holds: every match that the pattern and the "
        "earlier conditions accept passes it",
        rule.name());
    finding.help = "remove it, or check that it is the condition you meant";
    return finding;
  }
  finding.message = fmt::format(
      "this condition never holds, so rule '{}' never applies: no match that the pattern and the "
      "earlier conditions accept passes it",
      rule.name());
  finding.help = "compare it with the reference positions and their tolerances";
  RuleDefinition without = rule.definition();
  without.requirements.erase(without.requirements.begin() + static_cast<std::ptrdiff_t>(number));
  if (ChangedRules::replacing(rules, index, std::move(without)).chooses(pieceOf(reference, level)))
    finding.test = writeTest(reference, {fmt::format("{}: applies where it fits", rule.name()),
                                         {},
                                         fmt::format("rule \"{}\"", rule.name())});
  return finding;
}

SampledFinding idleZoneFinding(const RuleSet& rules, std::size_t index, std::size_t zone,
                               bool alwaysHolds) {
  SampledFinding finding = idleFinding(rules, index, 0, true);
  finding.element = -1;
  finding.zone = static_cast<int>(zone);
  finding.message = fmt::format("{} of rule '{}' {}", alwaysHolds ? "this condition" : "this zone",
                                rules.rules()[index].name(),
                                alwaysHolds ? "always holds where it is evaluated"
                                            : "is never used: its condition never holds");
  finding.help = alwaysHolds ? "leave out `when`, or check that it is the condition you meant"
                             : "remove it, or give it another condition";
  return finding;
}

void findIdleZones(const RuleSet& rules, std::size_t index, const SamplingOptions& options,
                   std::vector<SampledFinding>& findings) {
  const AF2Rule& rule = rules.rules()[index];
  const auto* zones = dynamic_cast<const ShapeZoneDef*>(rule.definition().zone.get());
  if (!zones) return;
  std::vector<Condition> failing;
  for (std::size_t i = 0; i < zones->alternatives().size(); ++i) {
    const Condition& when = zones->alternatives()[i].when;
    if (!when) break;
    const ConditionCheck check(rules, rule, when, rule.definition().requirements.size(), failing,
                               options);
    const bool always = check.alwaysHolds();
    if (always || check.neverHolds()) findings.push_back(idleZoneFinding(rules, index, i, always));
    if (always) break;  // later ones are not evaluated
    failing.push_back(when);
  }
}

}  // namespace

std::vector<SampledFinding> findIdleConditions(const RuleSet& rules, std::size_t index,
                                               const SamplingOptions& options) {
  std::vector<SampledFinding> findings;
  const std::size_t count = rules.rules()[index].definition().requirements.size();
  for (std::size_t number = 0; number < count; ++number) {
    const AF2Rule& rule = rules.rules()[index];
    const ConditionCheck check(rules, rule, rule.definition().requirements[number], number, {},
                               options);
    const bool always = check.alwaysHolds();
    if (!always && !check.neverHolds()) continue;
    findings.push_back(idleFinding(rules, index, number, always));
    if (!always) return findings;  // no match is left for later conditions
  }
  findIdleZones(rules, index, options, findings);
  return findings;
}

}  // namespace af2::dsl
