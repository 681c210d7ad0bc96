// Which rule set is run, and which ones it extends.
#pragma once

#include <vector>

#include "dsl/compile/library.h"
#include "dsl/compile/rule_set_compiler.h"

namespace af2::dsl {

/// The rule set of the main file after those that it extends, the farthest first; none if there is
/// none, which is told where one is needed.
std::vector<PlacedRuleSet> ruleSetChain(CompileContext& context, const Library& library,
                                        bool needsRuleSet);

}  // namespace af2::dsl
