// D3: is there a situation in which the rule is chosen?
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "dsl/match/match_sampler.h"
#include "dsl/proof/rule_sample.h"
#include "dsl/proof/test_text.h"
#include "engine/base/error.h"
#include "engine/step/single_step.h"

namespace af2::dsl {
namespace {

/// The number of levels above its first one at which a rule is tried.
constexpr int kHighestRise = 6;

/// Random vertices around the match but outside its zone. They may block other rules.
void addObstacles(FrontPiece& piece, const AF2FreeZone& zone, RandomNumbers& random) {
  const int count = static_cast<int>(random.between(0, 6));
  for (int i = 0; i < count; ++i) {
    const Point2 p{random.between(-1.5, 2.5), random.between(-0.5, 2.5)};
    if (zone.contains(p, ZoneBoundary::Counts)) continue;
    piece.isolated.push_back(piece.vertices.size());
    piece.vertices.push_back(p);
  }
}

/// The number of times that each rule was chosen, by rule; -1 for no rule.
using Winners = std::map<int, int>;

std::string describe(const RuleSet& rules, const Winners& winners) {
  const auto most = std::max_element(winners.begin(), winners.end(),
                                     [](auto& p, auto& q) { return p.second < q.second; });
  if (most->first < 0) return fmt::format("in {} of them no rule was chosen", most->second);
  return fmt::format("in {} of them rule '{}' was chosen", most->second,
                     rules.rules()[most->first].name());
}

/// Whether the rule is chosen in one random situation around a match.
bool isChosen(SingleStepper& stepper, const RuleSample& sample, const SampledMatch& one,
              RandomNumbers& random, Winners& winners) {
  const int maxLevel = sample.rules.maxLevel();
  const int last = std::min(sample.rule.definition().lastLevel.value_or(maxLevel), maxLevel);
  const int rise = random.unit() < 0.5 ? 0 : static_cast<int>(random.between(0, kHighestRise + 1));
  FrontPiece piece = pieceOf(one.match, std::min(sample.level + rise, last));
  addObstacles(piece, *one.zone, random);
  const auto chosen = stepper.chosenRule(piece);
  ++winners[chosen ? static_cast<int>(*chosen) : -1];
  return chosen == sample.index;
}

}  // namespace

std::optional<SampledFinding> findNeverChosen(const RuleSample& sample, SingleStepper& stepper,
                                              const SamplingOptions& options) {
  RandomNumbers random(options.seed + 7919 * (sample.index + 1));
  Winners winners;
  int situations = 0;
  for (const SampledMatch& one : sample.matches) {
    if (situations == options.situations) break;
    if (!one.zone || !one.placed) continue;
    ++situations;
    if (isChosen(stepper, sample, one, random, winners)) return std::nullopt;
  }
  if (situations == 0) return std::nullopt;

  const auto reference = PatternMatch::atReference(sample.rule, sample.level);
  SampledFinding finding = findingAbout(sample, Code::NeverChosen);
  finding.message = fmt::format("rule '{}' was never chosen in {} situations that it fits; {}",
                                sample.name(), situations, describe(sample.rules, winners));
  finding.help = "remove it, or let it match where other rules do not";
  finding.example = {reference.vertices(), sample.level, {}, {}};
  finding.test = writeTest(reference, {fmt::format("{}: is chosen where it fits", sample.name()),
                                       {},
                                       fmt::format("rule \"{}\"", sample.name())});
  return finding;
}

}  // namespace af2::dsl
