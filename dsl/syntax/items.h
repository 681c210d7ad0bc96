// The grammar's one entry, apart from Spirit.
#pragma once

#include "dsl/syntax/ast.h"
#include "dsl/syntax/syntax_errors.h"
#include "dsl/syntax/token.h"

namespace af2::dsl {

/// Reads the items from `first` on; the last word before `last` is an End. What cannot be read is
/// told, and left out. Returns where it stopped.
const Token* parseItems(const Token* first, const Token* last, SyntaxErrors& errors, File& file);

}  // namespace af2::dsl
