// The lexer: from text to words.
#pragma once

#include <vector>

#include "dsl/syntax/token.h"
#include "dsl/text/diagnostic.h"

namespace af2::dsl {

struct TokenList {
  std::vector<Token> tokens;  ///< ends with a token of kind End
  std::vector<Comment> comments;
  bool isCut = false;  ///< there were too many words; the last token is where reading ended
  bool isText = true;  ///< false: the file is not text, and nothing was read
};

/// Splits a text into words. Text that cannot be read is reported (codes L) and left out, or
/// replaced by a valid word of the same kind so that it causes no further errors. Reading ends
/// after `most` words.
TokenList readTokens(const SourceText& source, DiagnosticList& diagnostics,
                     std::size_t most = static_cast<std::size_t>(-1));

}  // namespace af2::dsl
