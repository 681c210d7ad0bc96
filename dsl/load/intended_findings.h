// Findings that the author of a rule file has allowed.
#pragma once

#include "dsl/load/loaded_file.h"
#include "dsl/load/rule_file.h"
#include "dsl/text/diagnostic.h"

namespace af2::dsl {

/// Whether the rule of a finding allows it, or the rule set allows it for all rules. All warnings
/// can be allowed, but only the errors G2 and Z1.
bool isMeantToBe(const LoadedFile& file, const Diagnostic& finding);

}  // namespace af2::dsl
