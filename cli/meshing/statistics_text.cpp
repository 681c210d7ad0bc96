// The tables and the JSON of run statistics.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "cli/meshing/rule_statistics.h"

namespace af2::cli {
namespace {

std::size_t refusedFor(const RuleCounts& rule, std::initializer_list<Refusal> reasons) {
  std::size_t sum = 0;
  for (const Refusal reason : reasons) sum += rule.refused[static_cast<std::size_t>(reason)];
  return sum;
}

std::size_t triedIn(const RuleCounts& rule) {
  std::size_t sum = rule.chosen;
  for (const std::size_t count : rule.refused) sum += count;
  return sum - refusedFor(rule, {Refusal::Class});
}

std::size_t matchedIn(const RuleCounts& rule) {
  return triedIn(rule) - refusedFor(rule, {Refusal::Pattern});
}

double meanLevel(const RuleCounts& rule) {
  return rule.chosen > 0 ? rule.levels / static_cast<double>(rule.chosen) : 0;
}

/// scores  ascending, at least one
double percentile(const std::vector<float>& scores, double share) {
  return scores[static_cast<std::size_t>(share * static_cast<double>(scores.size() - 1))];
}

std::string scoreColumns(const std::vector<float>& scores) {
  if (scores.empty()) return fmt::format("{:>8}  {:>9}  {:>9}  {:>9}\n", 0, "-", "-", "-");
  return fmt::format("{:8}  {:9.3g}  {:9.3g}  {:9.3g}\n", scores.size(), percentile(scores, 0.5),
                     percentile(scores, 0.95), percentile(scores, 1));
}

std::string ruleRow(const std::string& name, std::size_t width, const RuleCounts& rule,
                    double seconds, const std::vector<float>& scores) {
  const std::size_t zone = refusedFor(rule, {Refusal::ZoneHitByVertex, Refusal::ZoneHitByEdge});
  const std::size_t beaten = refusedFor(rule, {Refusal::Beaten});
  const double share = seconds > 0 ? 100 * rule.seconds / seconds : 0;
  return fmt::format("{:{}}  {:9}  {:9}  {:9}  {:9}  {:9}  {:9}  {:6.2f}  {:5}  {:5.1f}  ", name,
                     width, triedIn(rule), matchedIn(rule), zone,
                     matchedIn(rule) - zone - beaten - rule.chosen, beaten, rule.chosen,
                     meanLevel(rule), rule.highestLevel, share) +
         scoreColumns(scores);
}

std::string sourceTable(const RunStatistics& statistics) {
  std::string text =
      fmt::format("\n{:20}  {:>8}  worst {}\n", "elements by source", "elements", statistics.worst);
  for (std::size_t s = 0; s < kElementSources; ++s) {
    const RunStatistics::Source& source = statistics.sources[s];
    if (source.elements == 0) continue;
    text += fmt::format("{:20}  {:8}  {:5}\n", toString(static_cast<ElementSource>(s)),
                        source.elements, source.worst);
  }
  return text;
}

/// What fronts did beside adding elements; empty if they did nothing else.
std::string actTable(const FrontActCounts& acts) {
  if (acts == FrontActCounts{}) return "";
  std::string text = "\nacts of the fronts    number\n";
  acts.forEach([&](const char* name, std::size_t count) {
    if (count > 0) text += fmt::format("{:20}  {:8}\n", name, count);
  });
  return text;
}

double totalSeconds(const RunStatistics& statistics) {
  double sum = 0;
  for (const RuleCounts& rule : statistics.counts) sum += rule.seconds;
  return sum;
}

nlohmann::ordered_json jsonOf(const std::string& name, const RuleCounts& rule,
                              const std::vector<float>& scores) {
  nlohmann::ordered_json refused = nlohmann::ordered_json::object();
  for (std::size_t i = 1; i < RuleCounts::kReasons; ++i)
    if (rule.refused[i] > 0) refused[toString(static_cast<Refusal>(i))] = rule.refused[i];
  nlohmann::ordered_json entry{{"rule", name},
                               {"tried", triedIn(rule)},
                               {"matched", matchedIn(rule)},
                               {"matches", rule.matches},
                               {"refused", refused},
                               {"chosen", rule.chosen},
                               {"mean_level", meanLevel(rule)},
                               {"highest_level", rule.highestLevel},
                               {"seconds", rule.seconds},
                               {"elements", scores.size()}};
  if (!scores.empty())
    entry["score"] = {{"p50", percentile(scores, 0.5)},
                      {"p95", percentile(scores, 0.95)},
                      {"worst", percentile(scores, 1)}};
  return entry;
}

}  // namespace

std::string toText(const RuleSet& rules, const RunStatistics& statistics) {
  std::size_t width = 20;
  for (const AF2Rule& rule : rules.rules()) width = std::max(width, rule.name().size());
  std::string text = fmt::format(
      "{:{}}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}  {:>6}  {:>5}  {:>5}  {:>8}  {:>9}  {:>9}  "
      "{:>9}\n",
      "rule", width, "tried", "matched", "zone hit", "other", "beaten", "chosen", "level", "max",
      "time%", "elements", "score p50", "p95", "worst");
  const double seconds = totalSeconds(statistics);
  for (std::size_t r = 0; r < rules.rules().size(); ++r)
    text += ruleRow(rules.rules()[r].name(), width, statistics.counts[r], seconds,
                    statistics.scores[r]);
  const auto others = [&](const char* name, const std::vector<float>& scores) {
    if (!scores.empty())
      text += fmt::format("{:{}}  {:>86}  {}", name, width, "", scoreColumns(scores));
  };
  others("changed elements", statistics.changed);
  others("made without a rule", statistics.withoutRule);
  return text + actTable(statistics.acts) + sourceTable(statistics) + "\n" +
         statistics.finish.toText();
}

std::string toJson(const RuleSet& rules, const RunStatistics& statistics) {
  nlohmann::ordered_json json{{"rules", nlohmann::json::array()},
                              {"sources", nlohmann::json::array()}};
  for (std::size_t r = 0; r < rules.rules().size(); ++r)
    json["rules"].push_back(
        jsonOf(rules.rules()[r].name(), statistics.counts[r], statistics.scores[r]));
  for (std::size_t s = 0; s < kElementSources; ++s)
    json["sources"].push_back({{"source", toString(static_cast<ElementSource>(s))},
                               {"elements", statistics.sources[s].elements},
                               {"worst", statistics.sources[s].worst}});
  if (const FrontActCounts& acts = statistics.acts; acts != FrontActCounts{})
    acts.forEach([&](const char* name, std::size_t count) { json["acts"][name] = count; });
  json["finish"] = statistics.finish.toJson();
  return json.dump(2);
}

}  // namespace af2::cli
