// Blocks that a '}' too many closes before their clauses are over.
#pragma once

#include <vector>

#include "dsl/syntax/syntax_errors.h"
#include "dsl/syntax/token.h"

namespace af2::dsl {

/// A '}' ends a block too early if clauses follow it, and after them another '}' that would close
/// nothing. It is told and left out, so that the clauses are read where they belong.
void leaveOutEarlyBraces(std::vector<Token>& tokens, SyntaxErrors& errors);

}  // namespace af2::dsl
