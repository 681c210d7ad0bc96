// `meta { allow "Z1, M1"; }`: findings that are meant to be so.
#pragma once

#include <set>
#include <string>

#include "dsl/syntax/ast.h"
#include "dsl/text/diagnostic_codes.h"

namespace af2::dsl {

/// What an entry of `allow` lists, in short form and capital letters ("Z1"), whether there is such
/// a code or not; nothing for other entries.
std::set<std::string> codesListedIn(const MetaEntry& entry);

/// The codes that the `allow` entries of a clause list.
std::set<Code> allowedBy(const MetaClause& meta);

/// Whether a clause of the rule allows findings with this code.
bool allows(const Rule& rule, Code code);

}  // namespace af2::dsl
