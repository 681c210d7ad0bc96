#include "dsl/proof/rule_sample.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "dsl/checks/checks.h"
#include "dsl/match/match_sampler.h"

namespace af2::dsl {

PatternMatch roundedTo(const PatternMatch& match, double step) {
  const double scale = std::round(1 / step);  // dividing by it gives the shortest decimals
  std::vector<Point2> vertices;
  for (const Point2 p : match.vertices())
    vertices.push_back({std::round(p.x * scale) / scale, std::round(p.y * scale) / scale});
  return PatternMatch(match.rule(), std::move(vertices), match.level());
}

SampledMatch examine(PatternMatch match) {
  SampledMatch result{std::move(match), 0, {}, nullptr, Refusal::None};
  result.deviation = deviationOf(result.match);
  result.placed = result.match.placeAll();
  auto made = result.match.rule().definition().zone->makeFreeZone(result.match.binding());
  result.zone = std::move(made.zone);
  result.zoneRefusal = made.refusal;
  return result;
}

SampledFinding findingAbout(const RuleSample& sample, Code code) {
  SampledFinding finding(code);
  finding.rule = sample.index;
  return finding;
}

std::vector<int> levelsOf(const RuleSet& rules, const AF2Rule& rule) {
  const std::vector<int> references = referenceLevels(rule.definition());
  const int first = references.front();
  const int last =
      std::min({rule.definition().lastLevel.value_or(rules.maxLevel()), rules.maxLevel(),
                std::max(first + kLevelsLookedAt - 1, references.back())});
  if (first > last) return {};
  std::set<int> levels(references.begin(), references.end());
  levels.insert({first + 1, 2 * first + 1, 4 * first + 1, last});
  levels.erase(levels.upper_bound(last), levels.end());
  return {levels.begin(), levels.end()};
}

RuleSample sampleRule(const RuleSet& rules, std::size_t index, int level, int count,
                      std::uint64_t seed) {
  const AF2Rule& rule = rules.rules()[index];
  RuleSample sample{rules, index, rule, level, {}};
  MatchSampler sampler(rules, rule, level, seed + index);
  for (int i = 0; i < count; ++i) {
    auto match = sampler.next();
    if (!match) break;
    sample.matches.push_back(examine(std::move(*match)));
  }
  return sample;
}

}  // namespace af2::dsl
