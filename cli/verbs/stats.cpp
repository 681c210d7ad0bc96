// af2 stats
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>

#include "cli/meshing/replay.h"
#include "cli/program/exit_code.h"
#include "cli/program/verbs.h"
#include "geometry/mesh/element_scores.h"

namespace af2::cli {
namespace {

constexpr std::size_t kReasons = static_cast<std::size_t>(Refusal::Beaten) + 1;

/// What came of one rule in all steps of a run.
struct RuleCounts {
  std::array<std::size_t, kReasons> refused{};  ///< steps by reason
  std::size_t matches = 0, chosen = 0;
  double levels = 0;  ///< summed over the steps in which it was chosen
  int highestLevel = 0;
  std::vector<float> scores;  ///< of the elements of the mesh that it made

  std::size_t of(std::initializer_list<Refusal> reasons) const {
    std::size_t sum = 0;
    for (const Refusal reason : reasons) sum += refused[static_cast<std::size_t>(reason)];
    return sum;
  }
  std::size_t tried() const {
    std::size_t sum = chosen;
    for (const std::size_t count : refused) sum += count;
    return sum - of({Refusal::Class});
  }
  std::size_t matched() const { return tried() - of({Refusal::Pattern}); }
  double meanLevel() const { return chosen > 0 ? levels / static_cast<double>(chosen) : 0; }
  /// Of the scores, which are sorted; NaN if there are none.
  double percentile(double share) const {
    if (scores.empty()) return NAN;
    return scores[static_cast<std::size_t>(share * static_cast<double>(scores.size() - 1))];
  }
};

/// Counts for one front after another; every face has one of its own.
class Counter final : public AF2MeshingObserver {
 public:
  explicit Counter(std::size_t rules) : counts(rules) {}
  bool wantsRefusals() const override { return true; }
  void stepTaken(const StepReport& step) override {
    if (!step.applied) return;
    RuleCounts& rule = counts[step.rule];
    ++rule.chosen;
    rule.levels += step.level;
    rule.highestLevel = std::max(rule.highestLevel, step.level);
  }
  void rulesRefused(const StepReport&, std::span<const RuleRefusal> refusals) override {
    for (const RuleRefusal& refusal : refusals) {
      ++counts[refusal.rule].refused[static_cast<std::size_t>(refusal.reason)];
      counts[refusal.rule].matches += refusal.matches;
    }
  }
  std::vector<RuleCounts> counts;
};

struct Statistics {
  std::vector<RuleCounts> rules;
  std::vector<float> changed, withoutRule;  ///< scores of other elements, sorted
};

void add(const RuleCounts& part, RuleCounts& sum) {
  for (std::size_t i = 0; i < kReasons; ++i) sum.refused[i] += part.refused[i];
  sum.matches += part.matches;
  sum.chosen += part.chosen;
  sum.levels += part.levels;
  sum.highestLevel = std::max(sum.highestLevel, part.highestLevel);
}

Statistics statisticsOf(const Replay& replay) {
  const std::size_t count = replay.rules().rules().size();
  std::mutex mutex;
  std::list<Counter> counters;  // which stay where they are
  const geometry::ModelMesh mesh = replay.run([&](int) -> AF2MeshingObserver* {
    const std::lock_guard lock(mutex);
    return &counters.emplace_back(count);
  });
  Statistics statistics;
  statistics.rules.resize(count);
  for (const Counter& counter : counters)
    for (std::size_t rule = 0; rule < count; ++rule)
      add(counter.counts[rule], statistics.rules[rule]);
  const std::vector<float> scores = elementScores(mesh, replay.rules().definition(), 0);
  for (std::size_t e = 0; e < scores.size(); ++e) {
    const ElementOrigin& origin = mesh.origins[e];
    std::vector<float>& into = origin.isChanged       ? statistics.changed
                               : origin.rule >= count ? statistics.withoutRule
                                                      : statistics.rules[origin.rule].scores;
    if (!std::isnan(scores[e])) into.push_back(scores[e]);
  }
  for (RuleCounts& rule : statistics.rules) std::ranges::sort(rule.scores);
  std::ranges::sort(statistics.changed);
  std::ranges::sort(statistics.withoutRule);
  return statistics;
}

void printScores(const char* name, std::size_t width, const std::vector<float>& scores) {
  if (scores.empty()) return;
  RuleCounts row;
  row.scores = scores;
  fmt::print("{:{}}  {:>79}  {:>8}  {:9.3g}  {:9.3g}  {:9.3g}\n", name, width, "", scores.size(),
             row.percentile(0.5), row.percentile(0.95), row.percentile(1));
}

void print(const RuleSet& rules, const Statistics& statistics) {
  std::size_t width = 20;
  for (const AF2Rule& rule : rules.rules()) width = std::max(width, rule.name().size());
  fmt::print(
      "{:{}}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}  {:>6}  {:>5}  {:>8}  {:>9}  {:>9}  {:>9}\n",
      "rule", width, "tried", "matched", "zone hit", "other", "beaten", "chosen", "level", "max",
      "elements", "score p50", "p95", "worst");
  for (std::size_t r = 0; r < rules.rules().size(); ++r) {
    const RuleCounts& rule = statistics.rules[r];
    const std::size_t zone = rule.of({Refusal::ZoneHitByVertex, Refusal::ZoneHitByEdge});
    const std::size_t beaten = rule.of({Refusal::Beaten});
    fmt::print("{:{}}  {:9}  {:9}  {:9}  {:9}  {:9}  {:9}  {:6.2f}  {:5}  {:8}  ",
               rules.rules()[r].name(), width, rule.tried(), rule.matched(), zone,
               rule.matched() - zone - beaten - rule.chosen, beaten, rule.chosen, rule.meanLevel(),
               rule.highestLevel, rule.scores.size());
    if (rule.scores.empty())
      fmt::print("{:>9}  {:>9}  {:>9}\n", "-", "-", "-");
    else
      fmt::print("{:9.3g}  {:9.3g}  {:9.3g}\n", rule.percentile(0.5), rule.percentile(0.95),
                 rule.percentile(1));
  }
  printScores("changed elements", width, statistics.changed);
  printScores("made without a rule", width, statistics.withoutRule);
}

nlohmann::ordered_json jsonOf(const RuleSet& rules, const Statistics& statistics) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t r = 0; r < rules.rules().size(); ++r) {
    const RuleCounts& rule = statistics.rules[r];
    nlohmann::ordered_json refused;
    for (std::size_t i = 1; i < kReasons; ++i)
      if (rule.refused[i] > 0) refused[toString(static_cast<Refusal>(i))] = rule.refused[i];
    nlohmann::ordered_json entry{{"rule", rules.rules()[r].name()},
                                 {"tried", rule.tried()},
                                 {"matched", rule.matched()},
                                 {"matches", rule.matches},
                                 {"refused", refused},
                                 {"chosen", rule.chosen},
                                 {"mean_level", rule.meanLevel()},
                                 {"highest_level", rule.highestLevel},
                                 {"elements", rule.scores.size()}};
    if (!rule.scores.empty())
      entry["score"] = {{"p50", rule.percentile(0.5)},
                        {"p95", rule.percentile(0.95)},
                        {"worst", rule.percentile(1)}};
    json.push_back(std::move(entry));
  }
  return json;
}

}  // namespace

Action declareStats(CLI::App& command) {
  struct Options {
    std::string trace, format = "pretty";
  };
  const auto options = std::make_shared<Options>();
  command.add_option("TRACE", options->trace, "a trace (af2 mesh --trace)")
      ->type_name("")
      ->required();
  command.add_option("--format", options->format, "pretty or json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"pretty", "json"}).description(""));
  return [options] {
    const Trace trace = readTrace(options->trace);
    const Replay replay(trace);
    const Statistics statistics = statisticsOf(replay);
    if (options->format == "json")
      fmt::print("{}\n", jsonOf(replay.rules(), statistics).dump(2));
    else
      print(replay.rules(), statistics);
    return kComplete;
  };
}

}  // namespace af2::cli
