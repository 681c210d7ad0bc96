// A compiled rule set as text.
#pragma once

#include <string>

#include "engine/rule/rule_set.h"

namespace af2::cli {

/// The settings, then every rule: its pattern, what follows from its elements, and its points as
/// the engine evaluates them. `rule`: only the rule with this title; empty: all.
std::string dumpText(const RuleSet& rules, const std::string& rule);

}  // namespace af2::cli
