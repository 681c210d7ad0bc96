// The first words of a rule file: `af2 1;`.
#pragma once

#include <vector>

#include "dsl/syntax/syntax_errors.h"
#include "dsl/syntax/token.h"

namespace af2::dsl {

/// Reads the version, and reports one that is missing, misspelt or unknown (S7). Returns the first
/// word of the items, or null if this is not a rule file.
const Token* readVersion(const std::vector<Token>& tokens, SyntaxErrors& errors);

}  // namespace af2::dsl
