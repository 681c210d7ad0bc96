// Rule files for the verbs that need a rule set.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dsl/load/rule_file.h"

namespace af2::cli {

/// How much is said about a rule file before it is used, and whether it is checked.
struct RuleLoading {
  bool isQuiet = false;                   ///< errors are printed, nothing else
  bool isUnchecked = false;               ///< errors that a rule file may allow do not stop the run
  std::vector<std::string> plugins = {};  ///< libraries that register names, see plugins.h
};

/// The rules of `file`, with a rule set. Prints the errors of the file to stderr, those that the
/// checks prove by a counter-example among them. Unless quiet, says also how many warnings there
/// are and which rules are not proven to be sound.
///
/// The rule files that AF2 comes with are not checked again, unless they were edited.
///
/// Throws InputError if there is an error.
dsl::LoadedRules loadRuleSet(const std::filesystem::path& file, const RuleLoading& loading);

}  // namespace af2::cli
