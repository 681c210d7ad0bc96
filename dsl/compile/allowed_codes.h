// `meta { allow "Z1, M1"; }`: the codes of findings that the author of a rule allows.
#pragma once

#include <set>
#include <string>

#include "dsl/syntax/ast.h"
#include "dsl/text/diagnostic_codes.h"

namespace af2::dsl {

/// The codes that an entry of `allow` lists, in short form and capital letters ("Z1"), including
/// codes that do not exist. Empty for other entries.
std::set<std::string> codesListedIn(const MetaEntry& entry);

/// The codes that the `allow` entries of a clause list.
std::set<Code> allowedBy(const MetaClause& meta);

/// Whether a clause of the rule allows findings with this code.
bool allows(const Rule& rule, Code code);

}  // namespace af2::dsl
