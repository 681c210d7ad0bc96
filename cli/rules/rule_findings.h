// All that the checks find in a rule file.
#pragma once

#include <string>
#include <vector>

#include "dsl/load/rule_file.h"
#include "dsl/proof/sampled_checks.h"

namespace af2::cli {

struct FindingOptions {
  bool quick = false;              ///< nothing that looks at many matches
  int samples = 0;                 ///< for each rule; 0: as the checks see fit
  bool prove = false;              ///< proofs may take their time
  std::string pictures;            ///< folder for pictures of findings; empty: none
  std::vector<dsl::Code> allowed;  ///< codes that are not told
};

struct RuleFindings {
  std::vector<dsl::Diagnostic> diagnostics;  ///< in the order of the text
  std::size_t ruleCount = 0;
  std::size_t proven = 0;   ///< rules for which G2 and Z1 are proven for every match
  std::size_t sampled = 0;  ///< rules for which samples showed nothing against one of them
  std::size_t refuted = 0;  ///< rules with a counter-example
};

/// What is told of a file: from reading it, and from all matches of its sound rules.
RuleFindings findIn(const std::string& name, const FindingOptions& options);

}  // namespace af2::cli
