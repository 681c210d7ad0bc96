// `meta { allow "Z1, M1"; }`: findings that are meant to be so.
#pragma once

#include <set>
#include <string>

#include "dsl/syntax/ast.h"

namespace af2::dsl {

/// The codes that the `allow` entries of a clause list, in short form: "Z1".
std::set<std::string> allowedBy(const MetaClause& meta);

/// Whether a clause of the rule allows findings with this code.
bool allows(const Rule& rule, const std::string& code);

}  // namespace af2::dsl
