// The words of a rule file.
#pragma once

#include <string>
#include <vector>

#include "dsl/text/source_text.h"

namespace af2::dsl {

enum class TokenKind {
  Name,
  Number,
  String,
  Symbol,  ///< punctuation and operators; `text` says which
  End,     ///< the end of the file, always the last token
};

struct Token {
  TokenKind kind = TokenKind::End;
  Span span;
  std::string text;         ///< as written; for strings, their value
  double number = 0;        ///< of a number
  std::string doc;          ///< lines of `##` directly above, joined by line breaks
  bool startsLine = false;  ///< only spaces precede it on its line
  bool isDoubtful = false;  ///< faulty, or after unreadable text; the fault has been reported
  bool is(std::string_view symbolOrWord) const {
    return (kind == TokenKind::Symbol || kind == TokenKind::Name) && text == symbolOrWord;
  }
};

/// A comment as written, from its `#` to the end of the line.
struct Comment {
  Span span;
  std::string text;
  bool ownLine = false;  ///< only spaces precede it on its line
};

}  // namespace af2::dsl
