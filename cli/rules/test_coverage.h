// What the tests of a rule file exercise.
#pragma once

#include <string>
#include <vector>

#include "dsl/load/rule_file.h"

namespace af2::cli {

/// Clauses of one rule; a mirror counts on its own.
struct RuleCoverage {
  std::string title;
  std::size_t clauses = 0, exercised = 0;
  bool isChosen = false;             ///< in some test the rule was applied
  std::vector<std::string> missing;  ///< keywords of guards that never turned a match down
};

/// A clause that builds (front, at, new, tri, ...) is exercised once the rule is applied in a test;
/// a guard (require, zone) once it has turned a match down.
std::vector<RuleCoverage> testCoverage(const dsl::LoadedRules& loaded);

std::string toText(const std::vector<RuleCoverage>& coverage);

}  // namespace af2::cli
