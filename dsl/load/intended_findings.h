// Findings that the author of a rule file has allowed.
#pragma once

#include "dsl/load/loaded_file.h"
#include "dsl/load/rule_file.h"
#include "dsl/text/diagnostic.h"

namespace af2::dsl {

/// Whether the rule that a finding is about allows it, or the rule set does for all rules. Warnings
/// can be allowed, and of the errors G2 and Z1.
bool isMeantToBe(const LoadedFile& file, const Diagnostic& finding);

}  // namespace af2::dsl
