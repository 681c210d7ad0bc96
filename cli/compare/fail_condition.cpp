#include "cli/compare/fail_condition.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cli/program/usage_error.h"
#include "geometry/base/words.h"

namespace af2::cli {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& fault) {
  throw UsageError(fmt::format(
      "--fail-if \"{}\": {}; write worse, \"MEASURE worse\", \"MEASURE < NUMBER\" or \"MEASURE > "
      "NUMBER\"",
      text, fault));
}

void readMeasure(std::string_view word, FailCondition& condition) {
  if (const auto dot = word.find('.'); dot != std::string_view::npos) {
    const std::string_view stage = word.substr(0, dot);
    if (stage != "raw" && stage != "finished")
      refuse(condition.text, fmt::format("'{}' is neither raw nor finished", stage));
    condition.stage = stage == "raw" ? MeshStage::Raw : MeshStage::Finished;
    word.remove_prefix(dot + 1);
  }
  const auto measures = comparedMeasures();
  if (std::ranges::find(measures, word, &ComparedMeasure::name) == measures.end()) {
    std::vector<std::string_view> names;
    for (const ComparedMeasure& measure : measures) names.push_back(measure.name);
    refuse(condition.text, fmt::format("'{}' is not a measure, which are {}", word,
                                       geometry::listed(names, "and")));
  }
  condition.measure = word;
}

bool holds(const FailCondition& condition, const MeasureComparison& row) {
  switch (condition.kind) {
    case FailCondition::Kind::Worse:
      return row.verdict == Verdict::Worse;
    case FailCondition::Kind::Below:
      return row.pairs > 0 && row.difference < condition.bound;
    case FailCondition::Kind::Above:
      return row.pairs > 0 && row.difference > condition.bound;
  }
  return false;
}

}  // namespace

FailCondition parseFailCondition(const std::string& text) {
  FailCondition condition;
  condition.text = text;
  const std::vector<std::string_view> words = geometry::wordsIn(text);
  if (words.size() == 1 && words[0] == "worse") return condition;
  if (words.size() < 2) refuse(text, "this is no condition");
  readMeasure(words[0], condition);
  if (words[1] == "worse" && words.size() == 2) return condition;
  if ((words[1] != "<" && words[1] != ">") || words.size() != 3)
    refuse(text, "this is no condition");
  condition.kind = words[1] == "<" ? FailCondition::Kind::Below : FailCondition::Kind::Above;
  const auto bound = geometry::numberIn<double>(words[2]);
  if (!bound || !std::isfinite(*bound)) refuse(text, fmt::format("'{}' is not a number", words[2]));
  condition.bound = *bound;
  return condition;
}

std::optional<std::string> failureOf(const FailCondition& condition,
                                     const std::vector<MeasureComparison>& rows) {
  std::string list;
  for (const MeasureComparison& row : rows) {
    const bool isMeant = condition.measure.empty()
                             ? row.name != "time"
                             : row.name == condition.measure && row.stage == condition.stage;
    if (isMeant && holds(condition, row))
      list += fmt::format("{}{} {} {:+.4g}", list.empty() ? "" : ", ", toString(row.stage),
                          row.name, row.difference);
  }
  if (list.empty()) return std::nullopt;
  return fmt::format("--fail-if \"{}\" holds: {}", condition.text, list);
}

}  // namespace af2::cli
