// Finds the rule set of a file and the rule sets that it extends.
#pragma once

#include <vector>

#include "dsl/compile/library.h"
#include "dsl/compile/rule_set_compiler.h"

namespace af2::dsl {

/// The rule set of the main file, preceded by the rule sets that it extends, the most basic first.
/// Empty if the file has none; this is reported if one is needed.
std::vector<PlacedRuleSet> ruleSetChain(CompileContext& context, const Library& library,
                                        bool needsRuleSet);

}  // namespace af2::dsl
