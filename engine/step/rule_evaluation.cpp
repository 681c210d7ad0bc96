#include "engine/step/rule_evaluation.h"

#include <algorithm>
#include <span>

#include "engine/step/rule_scoring.h"

namespace af2 {
namespace {

struct Scored {
  RefusalCause refusal;
  std::optional<double> score;
};

/// The first element that does not turn left everywhere.
RefusalCause invertedElement(const RuleDefinition& rule, const std::vector<Point2>& vertices) {
  const auto isInverted = [&](const RuleElement& element) {
    return !turnsLeftEverywhere(ElementCorners(element, vertices.data()).span());
  };
  const auto found = std::ranges::find_if(rule.elements, isInverted);
  return {Refusal::Inverted, static_cast<int>(found - rule.elements.begin())};
}

Scored scoreOf(const RuleSet& rules, const RuleDefinition& rule,
               const std::vector<Point2>& vertices, const AF2Binding& binding) {
  const RuleScoring scoring(rules.definition());
  double score = 0;
  const Refusal refusal =
      scoring.scoreElements(rule.elements, vertices.data(), binding.level, score);
  if (refusal == Refusal::Inverted) return {invertedElement(rule, vertices), std::nullopt};
  const auto cost = costAt(rule, binding);
  if (refusal != Refusal::None || !cost) return {{Refusal::NoValue}, std::nullopt};
  score += *cost;
  return {{scoring.judge(rule.elements, vertices.data(), score, binding.level)}, score};
}

/// The given positions after the matched ones; no value if one is missing.
std::optional<std::vector<Point2>> allVertices(
    std::span<const Point2> matched, const std::vector<std::optional<Point2>>& newVertices) {
  std::vector<Point2> all(matched.begin(), matched.end());
  for (const auto& point : newVertices) {
    if (!point) return std::nullopt;
    all.push_back(*point);
  }
  return all;
}

}  // namespace

RefusalCause refusalOfMatch(const RuleSet& rules, const AF2Rule& rule, const AF2Binding& binding) {
  if (!rule.appliesAt(binding.level)) return {Refusal::Class};
  const RefusalCause misfit =
      patternMisfit(rule.definition(), binding, rules.matchTolerance(binding.level));
  return misfit.isNone() ? failedRequirement(rule.definition(), binding) : misfit;
}

RuleEvaluation evaluateMatch(const RuleSet& rules, const AF2Rule& rule, const AF2Binding& binding) {
  const RuleDefinition& definition = rule.definition();
  RuleEvaluation result;
  result.misfit = patternMisfit(definition, binding, rules.matchTolerance(binding.level));
  result.required = failedRequirement(definition, binding);
  result.newVertices = newVerticesAt(definition, binding);
  result.zone = definition.zone->makeFreeZone(binding);
  const auto vertices = allVertices(binding.vertices, result.newVertices);
  const Scored scored = vertices ? scoreOf(rules, definition, *vertices, binding)
                                 : Scored{{Refusal::NoValue}, std::nullopt};
  result.score = scored.score;
  const RefusalCause noValue =
      scored.refusal.reason == Refusal::NoValue ? scored.refusal : RefusalCause{};
  const RefusalCause level{rule.appliesAt(binding.level) ? Refusal::None : Refusal::Class};
  for (const RefusalCause& cause : {level, result.misfit, result.required, noValue,
                                    RefusalCause{result.zone.refusal}, scored.refusal})
    if (result.refused.isNone()) result.refused = cause;
  return result;
}

}  // namespace af2
