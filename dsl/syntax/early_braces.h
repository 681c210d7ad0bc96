// Finds an extra '}' that closes a block before its last clause.
#pragma once

#include <vector>

#include "dsl/syntax/syntax_errors.h"
#include "dsl/syntax/token.h"

namespace af2::dsl {

/// A '}' ends a block too early if clauses follow it, and after them another '}' without an opening
/// brace. Such a '}' is reported and left out, so that the clauses are read in their block.
void leaveOutEarlyBraces(std::vector<Token>& tokens, SyntaxErrors& errors);

}  // namespace af2::dsl
