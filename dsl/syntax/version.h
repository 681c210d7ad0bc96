// The first words of a rule file: `af2 1;`.
#pragma once

#include <vector>

#include "dsl/syntax/syntax_errors.h"
#include "dsl/syntax/token.h"

namespace af2::dsl {

/// Reads the version; one that is missing, misspelt or unknown is told (S7). Returns where the
/// items begin, or null if this is no rule file at all.
const Token* readVersion(const std::vector<Token>& tokens, SyntaxErrors& errors);

}  // namespace af2::dsl
