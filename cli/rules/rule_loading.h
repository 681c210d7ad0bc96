// Rule files for the verbs that need a rule set.
#pragma once

#include <filesystem>
#include <memory>

#include "engine/rule/rule_set.h"

namespace af2::cli {

/// The rule set of `file`. Prints what is wrong with the file, or worth a warning, to stderr;
/// throws InputError if there is an error.
std::shared_ptr<const RuleSet> loadRuleSet(const std::filesystem::path& file);

}  // namespace af2::cli
