#include "cli/compare/comparison_text.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace af2::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string numberOr(std::size_t count, double value) {
  return count > 0 ? fmt::format("{:.4g}", value) : "-";
}

std::string rowText(const MeasureComparison& row) {
  std::string text =
      fmt::format("{:<20}  {:>6}  {:>9}  {:>9}", row.name, row.pairs,
                  numberOr(row.firstCount, row.first), numberOr(row.secondCount, row.second));
  if (row.pairs == 0) return text + "\n";
  return text + fmt::format("  {:>+10.3g}  {:>22}  {}\n", row.difference,
                            fmt::format("[{:+.3g}, {:+.3g}]", row.low, row.high),
                            toString(row.verdict));
}

Json caseJson(const CaseResult& result) {
  Json json;
  for (const ComparedMeasure& measure : comparedMeasures()) {
    if (measure.isTime) continue;
    const std::optional<double> value = measure.of(result);
    json[std::string(measure.name)] = value ? Json(*value) : Json(nullptr);
  }
  if (!result.fault.empty()) json["fault"] = result.fault;
  return json;
}

Json rowJson(const MeasureComparison& row) {
  Json json{
      {"stage", toString(row.stage)}, {"measure", std::string(row.name)}, {"pairs", row.pairs}};
  json["a"] = row.firstCount > 0 ? Json(row.first) : Json(nullptr);
  json["b"] = row.secondCount > 0 ? Json(row.second) : Json(nullptr);
  if (row.pairs == 0) return json;
  json["difference"] = row.difference;
  json["interval"] = {row.low, row.high};
  json["verdict"] = toString(row.verdict);
  return json;
}

}  // namespace

std::string comparisonText(const ComparisonReport& report) {
  std::string text = fmt::format("A: {}\nB: {}\n{} models\n", report.first, report.second,
                                 report.result.cases.size());
  for (const MeshStage stage : kMeshStages) {
    text += fmt::format("\n{:<20}  {:>6}  {:>9}  {:>9}  {:>10}  {:>22}  {}\n",
                        stage == MeshStage::Raw ? "raw meshes" : "finished meshes", "models", "A",
                        "B", "B - A", "95 % interval", "B is");
    for (const MeasureComparison& row : report.rows)
      if (row.stage == stage) text += rowText(row);
  }
  return text;
}

std::string failedModelsText(const ComparisonReport& report) {
  constexpr int kMostNamed = 10;
  std::string text;
  for (std::size_t stage = 0; stage < kMeshStages.size(); ++stage)
    for (const std::size_t set : {kFirstSet, kSecondSet}) {
      std::string names;
      int count = 0;
      for (std::size_t i = 0; i < report.result.cases.size(); ++i) {
        const CaseResult& one = report.result.cases[i][stage][set];
        if (one.failedFaces == 0 || ++count > kMostNamed) continue;
        names += (names.empty() ? "" : "; ") + report.result.names[i];
        if (!one.fault.empty()) names += " (" + one.fault + ")";
      }
      if (count > kMostNamed) names += fmt::format(" and {} more", count - kMostNamed);
      if (count > 0)
        text += fmt::format("{} failed on {} {}: {}\n", set == kFirstSet ? "A" : "B", count,
                            stage == 0 ? "raw meshes" : "finished meshes", names);
    }
  return text;
}

Json comparisonJson(const ComparisonReport& report) {
  Json json{{"a", report.first}, {"b", report.second}, {"notes", report.notes}};
  json["measures"] = Json::array();
  for (const MeasureComparison& row : report.rows) json["measures"].push_back(rowJson(row));
  json["models"] = Json::array();
  for (std::size_t i = 0; i < report.result.cases.size(); ++i) {
    Json model{{"model", report.result.names[i]}};
    for (std::size_t stage = 0; stage < kMeshStages.size(); ++stage)
      model[toString(kMeshStages[stage])] = {
          {"a", caseJson(report.result.cases[i][stage][kFirstSet])},
          {"b", caseJson(report.result.cases[i][stage][kSecondSet])}};
    json["models"].push_back(std::move(model));
  }
  return json;
}

}  // namespace af2::cli
