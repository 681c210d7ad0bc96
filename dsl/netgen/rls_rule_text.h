// Writes a classical rule in the rule language.
#pragma once

#include <string>
#include <vector>

#include "dsl/netgen/rls_families.h"
#include "dsl/netgen/rls_rule.h"
#include "dsl/netgen/rls_twins.h"

namespace af2::dsl {

/// Names of matched vertices, then of new ones.
std::vector<std::string> vertexNames(const ClassicRule& rule);

/// `title` is the title of the rule. Nothing if its edges branch.
RuleText ruleText(const ClassicRule& rule, const std::string& title);

/// The `mirror` clause of `rule` that makes `other`.
std::string mirrorClause(const ClassicRule& rule, const ClassicRule& other, const Twin& twin,
                         const std::string& otherTitle);

}  // namespace af2::dsl
