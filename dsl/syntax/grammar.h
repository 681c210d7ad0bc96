// From text to tree. Only grammar.cpp and what it is written with (token_parsers.h) know
// Boost.Spirit.
#pragma once

#include <vector>

#include "dsl/syntax/ast.h"
#include "dsl/syntax/lexer.h"
#include "dsl/syntax/syntax_errors.h"
#include "dsl/text/diagnostic.h"
#include "dsl/text/source_text.h"

namespace af2::dsl {

/// Limits that keep any input, however wild, within time and stack.
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

/// Reads a file; whatever cannot be read is told (codes L and S) and left out of the tree. Each
/// broken clause is told once, and reading goes on behind it.
ParsedFile parseFile(const SourceText& source, DiagnosticList& diagnostics,
                     const ParseLimits& limits = {});

}  // namespace af2::dsl
