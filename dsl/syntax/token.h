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
  std::string text;         ///< as written; for strings what they stand for
  double number = 0;        ///< of a number
  std::string doc;          ///< lines of `##` right above, joined by line breaks
  bool startsLine = false;  ///< nothing but blanks before it on its line
  bool isDoubtful = false;  ///< faulty itself, or behind something unreadable: told already
  bool is(std::string_view symbolOrWord) const {
    return (kind == TokenKind::Symbol || kind == TokenKind::Name) && text == symbolOrWord;
  }
};

/// A comment as written, from its `#` to the end of the line.
struct Comment {
  Span span;
  std::string text;
  bool ownLine = false;  ///< nothing but blanks before it on its line
};

}  // namespace af2::dsl
