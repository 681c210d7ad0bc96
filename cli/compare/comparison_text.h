// A comparison of two rule sets as a table, as JSON and as a page.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "cli/compare/comparison.h"

namespace af2::cli {

struct ComparisonReport {
  std::string first, second;  ///< the rule sets, as on the command line
  SuiteResult result;
  std::vector<MeasureComparison> rows;
  std::vector<std::string> notes;
};

std::string comparisonText(const ComparisonReport& report);

/// The models of which either rule set failed, at most ten for each stage; empty if there are none.
std::string failedModelsText(const ComparisonReport& report);

/// With the values of each model.
nlohmann::ordered_json comparisonJson(const ComparisonReport& report);

/// A page with the table, and pictures of the meshes that `result` holds side by side. Throws
/// InputError if the file cannot be written.
void writeComparisonPage(const ComparisonReport& report, const std::filesystem::path& file);

}  // namespace af2::cli
