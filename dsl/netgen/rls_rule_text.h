// A classical rule in the words of this language.
#pragma once

#include <string>
#include <vector>

#include "dsl/netgen/rls_families.h"
#include "dsl/netgen/rls_rule.h"
#include "dsl/netgen/rls_twins.h"

namespace af2::dsl {

/// Names of matched vertices, then of new ones.
std::vector<std::string> vertexNames(const ClassicRule& rule);

/// `title` is what the rule is to be called. Nothing if its edges branch.
RuleText ruleText(const ClassicRule& rule, const std::string& title);

/// The clause by which `rule` gives `other` as its mirror image.
std::string mirrorClause(const ClassicRule& rule, const ClassicRule& other, const Twin& twin,
                         const std::string& otherTitle);

}  // namespace af2::dsl
