// The single entry to the grammar, free of Spirit.
#pragma once

#include "dsl/syntax/ast.h"
#include "dsl/syntax/syntax_errors.h"
#include "dsl/syntax/token.h"

namespace af2::dsl {

/// Reads the items from `first` on; the last word before `last` is an End. Text that cannot be read
/// is reported and left out. Returns the position after the last word read.
const Token* parseItems(const Token* first, const Token* last, SyntaxErrors& errors, File& file);

}  // namespace af2::dsl
