// All findings of the checks in a rule file.
#pragma once

#include <string>
#include <vector>

#include "dsl/load/rule_file.h"
#include "dsl/proof/sampled_checks.h"

namespace af2::cli {

struct FindingOptions {
  bool quick = false;                     ///< skip the checks that examine many matches
  int samples = 0;                        ///< for each rule; 0: the default of the checks
  bool prove = false;                     ///< allow proofs more time
  std::string pictures;                   ///< folder for pictures of findings; empty: none
  std::vector<dsl::Code> allowed;         ///< codes that are not reported
  std::vector<std::string> plugins = {};  ///< libraries that register names, see plugins.h
};

struct RuleFindings {
  std::vector<dsl::Diagnostic> diagnostics;  ///< in the order of the text
  std::size_t ruleCount = 0;
  std::size_t proven = 0;   ///< rules for which G2 and Z1 are proven for every match
  std::size_t sampled = 0;  ///< other rules for which no sample refuted G2 or Z1
  std::size_t refuted = 0;  ///< rules with a counter-example
};

/// The errors that counter-examples prove, from a short search: a rule counts as sampled if neither
/// a proof nor a counter-example is found in it.
RuleFindings provenErrorsIn(const dsl::LoadedRules& loaded);

/// The findings in a file: from its text, and from all matches of its sound rules.
RuleFindings findIn(const std::string& name, const FindingOptions& options);

}  // namespace af2::cli
