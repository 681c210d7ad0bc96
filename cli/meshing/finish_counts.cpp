#include "cli/meshing/finish_counts.h"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace af2::cli {

void FinishCounts::actKept(const FinishAct& act) {
  Count& count = counts_[static_cast<std::size_t>(act.kind)];
  ++count.number;
  count.better += act.worstAfter < act.worstBefore;
  // A mean of elements without an area would say nothing.
  if (!std::isfinite(act.worstBefore) || !std::isfinite(act.worstAfter)) return;
  ++count.finite;
  count.before += act.worstBefore;
  count.after += act.worstAfter;
}

void FinishCounts::add(const FinishCounts& other) {
  for (std::size_t kind = 0; kind < counts_.size(); ++kind) {
    counts_[kind].number += other.counts_[kind].number;
    counts_[kind].better += other.counts_[kind].better;
    counts_[kind].finite += other.counts_[kind].finite;
    counts_[kind].before += other.counts_[kind].before;
    counts_[kind].after += other.counts_[kind].after;
  }
}

std::string FinishCounts::toText() const {
  std::string lines;
  for (std::size_t kind = 0; kind < counts_.size(); ++kind) {
    const Count& count = counts_[kind];
    if (count.number == 0) continue;
    lines += fmt::format("{:20}  {:9}  {:9}  {:17.4g}  {:16.4g}\n",
                         toString(static_cast<FinishAct::Kind>(kind)), count.number, count.better,
                         count.mean(count.before), count.mean(count.after));
  }
  if (lines.empty()) return {};
  return fmt::format("{:20}  {:>9}  {:>9}  {:>17}  {:>16}\n", "change after front", "number",
                     "better", "mean worst before", "mean worst after") +
         lines;
}

nlohmann::ordered_json FinishCounts::toJson() const {
  auto json = nlohmann::ordered_json::array();
  for (std::size_t kind = 0; kind < counts_.size(); ++kind) {
    const Count& count = counts_[kind];
    if (count.number == 0) continue;
    json.push_back({{"change", toString(static_cast<FinishAct::Kind>(kind))},
                    {"number", count.number},
                    {"better", count.better},
                    {"mean_worst_before", count.mean(count.before)},
                    {"mean_worst_after", count.mean(count.after)}});
  }
  return json;
}

}  // namespace af2::cli
