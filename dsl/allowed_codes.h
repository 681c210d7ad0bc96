// `meta { allow "Z1, M1"; }`: findings that are meant to be so.
#pragma once

#include <set>
#include <string>

#include "dsl/ast.h"
#include "dsl/diagnostic.h"
#include "dsl/rule_file.h"

namespace af2::dsl {

/// The codes that the `allow` entries of a clause list, in short form: "Z1".
std::set<std::string> allowedBy(const MetaClause& meta);

/// Whether the rule that a finding is about allows it, or the rule set does for all rules. Warnings
/// can be allowed, and of the errors G2 and Z1.
bool isMeantToBe(const LoadedFile& file, const Diagnostic& finding);

}  // namespace af2::dsl
