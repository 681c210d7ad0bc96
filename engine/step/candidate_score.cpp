#include "engine/step/candidate_score.h"

#include "engine/rule/rule_at_match.h"
#include "engine/step/surroundings.h"

namespace af2 {
namespace {

void placeAffinePoints(const CompiledRule& rule, Match& match) {
  Point2* points = match.points.data() + rule.matchedCount;
  double x[AffineBatch::kCapacity], y[AffineBatch::kCapacity];
  rule.newPoints->evaluate(match.points.data(), x, y);
  for (int k = 0; k < rule.newCount; ++k) points[k] = {x[k], y[k]};
}

Refusal placeNewPoints(const CompiledRule& rule, const AF2Binding& binding, Match& match) {
  Point2* points = match.points.data() + rule.matchedCount;
  if (rule.newPoints) {
    placeAffinePoints(rule, match);
    return Refusal::None;
  }
  const RuleDefinition& definition = rule.rule->definition();
  for (std::size_t i = 0; i < definition.newVertices.size(); ++i) {
    const auto point = newVertexAt(definition, i, binding);
    if (!point) return Refusal::NoValue;
    *points++ = *point;
  }
  return Refusal::None;
}

}  // namespace

Refusal CandidateScorer::evaluate(const StepView& view, Candidate& candidate) const {
  const CompiledRule& rule = *candidate.rule;
  if (!rule.isPlain || !rule.newPoints) return evaluateOpenly(view, candidate);
  placeAffinePoints(rule, candidate.match);
  const Refusal refusal = scoreElements(view, candidate);
  return refusal == Refusal::None ? judge(view, candidate) : refusal;
}

/// The general form: for a rule that queries its surroundings or has new vertices of any kind.
Refusal CandidateScorer::evaluateOpenly(const StepView& view, Candidate& candidate) const {
  const CompiledRule& rule = *candidate.rule;
  const RuleDefinition& definition = rule.rule->definition();
  const FrontSurroundings surroundings(view, index_, *rule.rule, candidate.match, size_, valence_);
  const AF2Binding binding{candidate.matchedPoints(), view.level, &surroundings};
  if (const RefusalCause failed = failedRequirement(definition, binding); !failed.isNone())
    return failed.reason;
  if (const Refusal r = placeNewPoints(rule, binding, candidate.match); r != Refusal::None)
    return r;
  if (const Refusal r = scoreElements(view, candidate); r != Refusal::None) return r;
  const auto cost = costAt(definition, binding);
  if (!cost) return Refusal::NoValue;
  candidate.score += *cost;
  return judge(view, candidate);
}

Refusal CandidateScorer::scoreElements(const StepView& view, Candidate& candidate) const {
  return rules_.scoring().scoreElements(candidate.rule->rule->definition().elements,
                                        candidate.match.points.data(), view.level, candidate.score);
}

Refusal CandidateScorer::judge(const StepView& view, const Candidate& candidate) const {
  return rules_.scoring().judge(candidate.rule->rule->definition().elements,
                                candidate.match.points.data(), candidate.score, view.level);
}

}  // namespace af2
