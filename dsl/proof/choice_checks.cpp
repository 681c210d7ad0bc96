// D3: is there a situation in which the rule is chosen?
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "dsl/checks/accepted_scores.h"
#include "dsl/match/match_sampler.h"
#include "dsl/proof/changed_rules.h"
#include "dsl/proof/rule_sample.h"
#include "dsl/proof/test_text.h"
#include "engine/step/rule_evaluation.h"
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

/// A random situation around a match.
FrontPiece situationAround(const RuleSample& sample, const SampledMatch& one,
                           RandomNumbers& random) {
  const int maxLevel = sample.rules.maxLevel();
  const int last = std::min(sample.rule.definition().lastLevel.value_or(maxLevel), maxLevel);
  const int rise = random.unit() < 0.5 ? 0 : static_cast<int>(random.between(0, kHighestRise + 1));
  FrontPiece piece = pieceOf(one.match, std::min(sample.level + rise, last));
  addObstacles(piece, *one.zone, random);
  return piece;
}

/// How close a rule came to being chosen where it was not.
struct NearMiss {
  double score = 0;  ///< of the rule
  double limit = 0;  ///< what it would have had to be less than
  int level = 1;
};

void keepNearer(std::optional<NearMiss>& nearest, const NearMiss& other) {
  if (!nearest || other.score - other.limit < nearest->score - nearest->limit) nearest = other;
}

std::string shortNumber(double value) { return fmt::format("{:.3g}", value + 0.0); }

/// Why a rule was not chosen, over all situations.
class Refusals {
 public:
  explicit Refusals(const RuleSample& sample) : sample_(sample) {}

  void addWithoutValue() { ++withoutValue_; }

  void add(SingleStepper& stepper, const SampledMatch& one, const FrontPiece& piece) {
    const SingleStep step = stepper.take(piece);
    const auto refusal = std::ranges::find(step.refusals, sample_.index, &RuleRefusal::rule);
    const Refusal reason = refusal == step.refusals.end() ? Refusal::None : refusal->reason;
    const PatternMatch match(sample_.rule, one.match.vertices(), piece.level);
    const auto score = evaluateMatch(sample_.rules, sample_.rule, match.binding()).score;
    if (reason == Refusal::NoValue) {
      ++withoutValue_;
    } else if (reason == Refusal::Beaten && step.rule && score) {
      ++beaten_;
      Winner& winner = winners_[*step.rule];
      ++winner.count;
      keepNearer(winner.nearest, {*score, step.score, piece.level});
    } else if (reason == Refusal::Score && score) {
      ++notAccepted_;
      const auto limit = acceptedBelow(*sample_.rules.definition().acceptance, *score, piece.level);
      keepNearer(nearlyAccepted_, {*score, limit.value_or(0), piece.level});
    } else {
      ++other_;
    }
  }

  /// "in 900 of them it was beaten, mostly by rule 'better', whose score was 0 where this one's was
  /// 0.1; in 100 of them it had no value"
  std::string text() const {
    std::vector<std::string> parts;
    if (beaten_ > 0) parts.push_back(beatenText());
    if (notAccepted_ > 0)
      parts.push_back(fmt::format(
          "in {} of them its score was not accepted: it was {} at best (level {}), and `accept` "
          "allows less than {}",
          notAccepted_, shortNumber(nearlyAccepted_->score), nearlyAccepted_->level,
          shortNumber(nearlyAccepted_->limit)));
    if (withoutValue_ > 0)
      parts.push_back(fmt::format("in {} of them it had no value (a division by zero or the like)",
                                  withoutValue_));
    if (other_ > 0) parts.push_back(fmt::format("in {} of them it was refused", other_));
    std::string all;
    for (const std::string& part : parts) all += (all.empty() ? "" : "; ") + part;
    return all;
  }

  /// The way out of the commonest case.
  std::string help() const {
    if (withoutValue_ > std::max(beaten_, notAccepted_))
      return "write its expressions so that they have a value at these matches";
    if (notAccepted_ > beaten_)
      return "accept higher scores in the rule set, or give the rule a lower `cost`";
    if (beaten_ == 0) return "let it match where the others do not, or remove it";
    const NearMiss& miss = *mostFrequent().second.nearest;
    if (isTie(miss))
      return "remove it, give it a smaller free zone, or a smaller `priority` or `cost`";
    return fmt::format(
        "remove it, give it a smaller free zone, or lower its `cost` by more than {}",
        shortNumber(miss.score - miss.limit));
  }

 private:
  struct Winner {
    int count = 0;
    std::optional<NearMiss> nearest;
  };

  static bool isTie(const NearMiss& miss) { return miss.score - miss.limit < 1e-9; }

  const std::pair<const std::size_t, Winner>& mostFrequent() const {
    return *std::ranges::max_element(winners_, {},
                                     [](const auto& entry) { return entry.second.count; });
  }

  std::string beatenText() const {
    const auto& [rule, winner] = mostFrequent();
    const std::string name = sample_.rules.rules()[rule].name();
    const std::string scores =
        isTie(*winner.nearest)
            ? fmt::format("which had the same score of {} and comes first",
                          shortNumber(winner.nearest->limit))
            : fmt::format("whose score was {} where this one's was {}",
                          shortNumber(winner.nearest->limit), shortNumber(winner.nearest->score));
    return fmt::format("in {} of them it was beaten, {}by rule '{}', {}", beaten_,
                       winner.count < beaten_ ? "mostly " : "", name, scores);
  }

  const RuleSample& sample_;
  int beaten_ = 0, notAccepted_ = 0, withoutValue_ = 0, other_ = 0;
  std::map<std::size_t, Winner> winners_;
  std::optional<NearMiss> nearlyAccepted_;
};

bool isWithoutValue(const SampledMatch& one) {
  return !one.placed || one.zoneRefusal == Refusal::NoValue;
}

/// The reference, or else another match, where the rule would be chosen if it cost less.
std::optional<PatternMatch> matchToBeChosen(const RuleSample& sample) {
  constexpr std::size_t kTries = 60;
  ChangedRules changed =
      ChangedRules::replacing(sample.rules, sample.index, atLowCost(sample.rule.definition()));
  const auto reference = PatternMatch::atReference(sample.rule, sample.level);
  if (changed.chooses(pieceOf(reference, sample.level))) return reference;
  for (std::size_t i = 0; i < std::min(kTries, sample.matches.size()); ++i)
    if (changed.chooses(pieceOf(sample.matches[i].match, sample.level)))
      return sample.matches[i].match;
  return std::nullopt;
}

/// Nothing if the rule is chosen in one of the situations, or there are none.
std::optional<Refusals> refusalsEverywhere(const RuleSample& sample, SingleStepper& stepper,
                                           const SamplingOptions& options, int& situations) {
  RandomNumbers random(options.seed + 7919 * (sample.index + 1));
  std::vector<std::pair<const SampledMatch*, FrontPiece>> tried;
  Refusals refusals(sample);
  situations = 0;
  for (const SampledMatch& one : sample.matches) {
    if (situations == options.situations) break;
    if (isWithoutValue(one)) {
      ++situations;
      refusals.addWithoutValue();
    }
    if (!one.zone || !one.placed) continue;
    ++situations;
    FrontPiece piece = situationAround(sample, one, random);
    if (stepper.chosenRule(piece) == sample.index) return std::nullopt;
    tried.emplace_back(&one, std::move(piece));
  }
  if (situations == 0) return std::nullopt;
  for (const auto& [one, piece] : tried) refusals.add(stepper, *one, piece);
  return refusals;
}

}  // namespace

std::optional<SampledFinding> findNeverChosen(const RuleSample& sample, SingleStepper& stepper,
                                              const SamplingOptions& options) {
  int situations = 0;
  const auto refusals = refusalsEverywhere(sample, stepper, options, situations);
  if (!refusals) return std::nullopt;
  SampledFinding finding = findingAbout(sample, Code::NeverChosen);
  finding.message = fmt::format("rule '{}' was never chosen in {} situations that it fits: {}",
                                sample.name(), situations, refusals->text());
  finding.help = refusals->help();
  const auto match = matchToBeChosen(sample);
  finding.example = {
      match.value_or(PatternMatch::atReference(sample.rule, sample.level)).vertices(),
      sample.level,
      {},
      {}};
  if (match)
    finding.test = writeTest(*match, {fmt::format("{}: is chosen where it fits", sample.name()),
                                      {},
                                      fmt::format("rule \"{}\"", sample.name())});
  return finding;
}

}  // namespace af2::dsl
