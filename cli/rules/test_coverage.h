// Which clauses the tests of a rule file exercise.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "dsl/load/rule_file.h"

namespace af2::cli {

/// Coverage of one rule; a mirrored rule is counted separately.
struct RuleCoverage {
  std::string title;
  std::size_t clauses = 0, exercised = 0;
  bool isChosen = false;             ///< whether the rule was applied in some test
  std::vector<std::string> missing;  ///< keywords of guards that never refused a match
};

/// A clause that builds (front, at, new, tri, ...) is exercised when the rule is applied in a test;
/// a guard (require, zone) when it has refused a match.
std::vector<RuleCoverage> testCoverage(const dsl::LoadedRules& loaded);

std::string toText(const std::vector<RuleCoverage>& coverage);

/// {"file", "clauses", "exercised", "rules": [{"title", "chosen", "clauses", "exercised",
/// "never_refused"}]}
nlohmann::ordered_json toJson(const std::string& file, const std::vector<RuleCoverage>& coverage);

}  // namespace af2::cli
