// The parser: from text to tree. Only grammar.cpp and token_parsers.h use Boost.Spirit.
#pragma once

#include <vector>

#include "dsl/syntax/ast.h"
#include "dsl/syntax/lexer.h"
#include "dsl/syntax/syntax_errors.h"
#include "dsl/text/diagnostic.h"
#include "dsl/text/source_text.h"

namespace af2::dsl {

/// Limits that bound the time and stack for any input.
struct ParseLimits {
  std::size_t bytes = 8u << 20;
  std::size_t words = 400'000;
  int nesting = 100;     ///< brackets within brackets
  int operators = 1500;  ///< in one statement
};

struct ParsedFile {
  File file;
  std::vector<Comment> comments;
  std::vector<BrokenStretch> broken;
};

/// Reads a file. Text that cannot be read is reported (codes L and S) and left out of the tree.
/// Each broken clause is reported once, and the parser continues after it.
ParsedFile parseFile(const SourceText& source, DiagnosticList& diagnostics,
                     const ParseLimits& limits = {});

}  // namespace af2::dsl
