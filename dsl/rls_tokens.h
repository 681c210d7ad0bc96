// The words, numbers and signs of Netgen's rule files.
#pragma once

#include <string_view>
#include <vector>

#include "dsl/source_text.h"

namespace af2::dsl {

enum class RlsTokenKind { Word, Number, String, Sign, End };

struct RlsToken {
  RlsTokenKind kind = RlsTokenKind::End;
  std::string_view text;
  Span span;
  bool is(std::string_view other) const { return kind != RlsTokenKind::String && text == other; }
};

/// All of a text, blanks left out; the last token is an End. Never fails: what is nothing else is a
/// Sign of one character.
std::vector<RlsToken> rlsTokensOf(std::string_view text);

}  // namespace af2::dsl
