#include "cli/meshing/rule_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/mesh/element_scores.h"

namespace af2::cli {

RuleCounts& RuleCounts::operator+=(const RuleCounts& other) {
  for (std::size_t i = 0; i < kReasons; ++i) refused[i] += other.refused[i];
  matches += other.matches;
  chosen += other.chosen;
  levels += other.levels;
  highestLevel = std::max(highestLevel, other.highestLevel);
  seconds += other.seconds;
  return *this;
}

void RuleCounters::Counter::stepTaken(const StepReport& step) {
  if (!step.applied) return;
  RuleCounts& rule = counts[step.rule];
  ++rule.chosen;
  rule.levels += step.level;
  rule.highestLevel = std::max(rule.highestLevel, step.level);
}

void RuleCounters::Counter::rulesRefused(const StepReport& step,
                                         std::span<const RuleRefusal> refusals) {
  for (const RuleRefusal& refusal : refusals) {
    RuleCounts& rule = counts[refusal.rule];
    rule.matches += refusal.matches;
    rule.seconds += refusal.seconds;
    ++rule.refused[static_cast<std::size_t>(refusal.reason)];
  }
  if (step.applied) counts[step.rule].seconds += step.ruleSeconds;
}

AF2MeshingObserver* RuleCounters::observerOfFace() {
  const std::lock_guard lock(mutex_);
  return &counters_.emplace_back(rules_);
}

std::vector<RuleCounts> RuleCounters::total() const {
  std::vector<RuleCounts> sum(rules_);
  for (const Counter& counter : counters_)
    for (std::size_t rule = 0; rule < rules_; ++rule) sum[rule] += counter.counts[rule];
  return sum;
}

FinishCounts RuleCounters::finish() const {
  FinishCounts sum;
  for (const Counter& counter : counters_) sum.add(counter.finish);
  return sum;
}

const char* toString(ElementSource source) {
  switch (source) {
    case ElementSource::Row:
      return "row";
    case ElementSource::Corner:
      return "corner";
    case ElementSource::Meeting:
      return "fronts meet";
    case ElementSource::LoopEnd:
      return "end of a loop";
    case ElementSource::Closing:
      return "closing";
    case ElementSource::Fan:
      return "fan";
    case ElementSource::Changed:
      return "optimization";
  }
  return "unknown";
}

ElementSource sourceOf(const AF2Rule& rule) {
  const RuleDefinition& definition = rule.definition();
  if (rule.newEdges().empty()) return ElementSource::LoopEnd;
  std::vector<bool> isReached(definition.vertices.size(), false);
  isReached[0] = isReached[1] = true;
  for (std::size_t round = 0; round < definition.edges.size(); ++round)
    for (const PatternEdge& edge : definition.edges) {
      const auto from = static_cast<std::size_t>(edge.from), to = static_cast<std::size_t>(edge.to);
      if (isReached[from] || isReached[to]) isReached[from] = isReached[to] = true;
    }
  if (std::ranges::count(isReached, false) > 0) return ElementSource::Meeting;
  return rule.consumedEdges().size() > 1 ? ElementSource::Corner : ElementSource::Row;
}

namespace {

ElementSource sourceOfElement(const ElementOrigin& origin, const RuleSet& rules) {
  if (origin.isChanged) return ElementSource::Changed;
  const std::size_t count = rules.rules().size();
  if (origin.rule < count) return sourceOf(rules.rules()[origin.rule]);
  return origin.rule == originOf(geometry::WithoutRule::Fan, rules).rule ? ElementSource::Fan
                                                                         : ElementSource::Closing;
}

/// The elements with the worst scores, one in a hundred; ties go to the lower index.
std::vector<std::size_t> worstOf(const std::vector<float>& scores) {
  std::vector<std::size_t> scored;
  for (std::size_t e = 0; e < scores.size(); ++e)
    if (!std::isnan(scores[e])) scored.push_back(e);
  const std::size_t count = std::min(scored.size(), scored.size() / 100 + 1);
  std::ranges::partial_sort(scored, scored.begin() + static_cast<std::ptrdiff_t>(count),
                            [&](std::size_t one, std::size_t other) {
                              return scores[one] != scores[other] ? scores[one] > scores[other]
                                                                  : one < other;
                            });
  scored.resize(count);
  return scored;
}

}  // namespace

RunStatistics statisticsOf(const RuleSet& rules, const geometry::ModelMesh& mesh,
                           const RuleCounters& counters) {
  RunStatistics statistics;
  statistics.counts = counters.total();
  statistics.finish = counters.finish();
  for (const geometry::FaceReport& face : mesh.faces) statistics.acts += face.acts;
  statistics.scores.resize(statistics.counts.size());
  const std::vector<float> scores = mesh.scores.size() == mesh.elements.size()
                                        ? mesh.scores
                                        : elementScores(mesh, rules.definition(), 0);
  for (std::size_t e = 0; e < scores.size(); ++e) {
    const ElementOrigin& origin = mesh.origins[e];
    const ElementSource source = sourceOfElement(origin, rules);
    ++statistics.sources[static_cast<std::size_t>(source)].elements;
    std::vector<float>& into = source == ElementSource::Changed ? statistics.changed
                               : origin.rule >= statistics.scores.size()
                                   ? statistics.withoutRule
                                   : statistics.scores[origin.rule];
    if (!std::isnan(scores[e])) into.push_back(scores[e]);
  }
  for (std::vector<float>& of : statistics.scores) std::ranges::sort(of);
  std::ranges::sort(statistics.changed);
  std::ranges::sort(statistics.withoutRule);
  const std::vector<std::size_t> worst = worstOf(scores);
  statistics.worst = worst.size();
  for (const std::size_t e : worst)
    ++statistics.sources[static_cast<std::size_t>(sourceOfElement(mesh.origins[e], rules))].worst;
  return statistics;
}

}  // namespace af2::cli
