// Whether two rules do the same, however their vertices are numbered and named.
#pragma once

#include <string>

#include "engine/rule/rule.h"

namespace af2::dsl {

/// Compares pattern and elements exactly, and positions, conditions, costs and zones at a fixed set
/// of matches around the reference.
bool doTheSame(const RuleDefinition& first, const RuleDefinition& second);

/// What keeps two rules that are alike from doing the same: "new vertices by up to 0.46, free zones
/// by up to 0.12".
std::string differenceOf(const RuleDefinition& first, const RuleDefinition& second);

/// Whether they look for the same pattern and make the same elements, wherever they put them.
bool areAlike(const RuleDefinition& first, const RuleDefinition& second);

}  // namespace af2::dsl
