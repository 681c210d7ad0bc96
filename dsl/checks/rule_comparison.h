// Whether two rules have the same effect, independent of the numbers and names of vertices.
#pragma once

#include <string>

#include "engine/rule/rule_set.h"

namespace af2::dsl {

/// Compares pattern and elements exactly, and positions, conditions, costs and zones at a fixed set
/// of matches around the reference.
bool doTheSame(const RuleDefinition& first, const RuleDefinition& second);

/// The difference between two similar rules: "new vertices by up to 0.46, free zones by up to
/// 0.12".
std::string differenceOf(const RuleDefinition& first, const RuleDefinition& second);

/// Whether the rules have the same pattern and the same elements; positions may differ.
bool areAlike(const RuleDefinition& first, const RuleDefinition& second);

/// Whether two rules apply at the same matches, with the same free zones, costs and scores,
/// whatever elements they make. Of two such rules the one that comes later is never chosen.
bool alwaysTie(const RuleDefinition& first, const RuleDefinition& second,
               const RuleSetDefinition& settings);

}  // namespace af2::dsl
