// The formatter: prints rule files as canonical text.
#pragma once

#include <string>
#include <vector>

#include "dsl/syntax/grammar.h"
#include "dsl/text/diagnostic.h"

namespace af2::dsl {

/// Prints one clause per line, with the keywords of a block padded to the same width and one blank
/// line between items (blank lines between single-line items are kept). Comments keep their places.
/// `parsed` must have no broken parts.
std::string print(const SourceText& source, const ParsedFile& parsed);

struct Formatted {
  std::string text;                     ///< empty if there are errors
  std::vector<Diagnostic> diagnostics;  ///< the errors that prevented reading the file
};

/// Reads and prints a text. A text that cannot be read gives errors and an empty text.
Formatted format(std::string name, std::string text);

/// One expression on one line.
std::string printExpression(const Expr& expr);

}  // namespace af2::dsl
