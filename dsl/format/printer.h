// Canonical text of rule files: the formatter.
#pragma once

#include <string>
#include <vector>

#include "dsl/syntax/grammar.h"
#include "dsl/text/diagnostic.h"

namespace af2::dsl {

/// One clause per line, the first words of a block's clauses padded to one column, one blank line
/// between items (blank lines between single-line items are kept), comments where they stood.
/// `parsed` must be without broken parts.
std::string print(const SourceText& source, const ParsedFile& parsed);

struct Formatted {
  std::string text;                     ///< empty if there are errors
  std::vector<Diagnostic> diagnostics;  ///< what kept the file from being read
};

/// Reads and prints. Text that cannot be read is left alone: errors and no text.
Formatted format(std::string name, std::string text);

/// One expression on one line.
std::string printExpression(const Expr& expr);

}  // namespace af2::dsl
