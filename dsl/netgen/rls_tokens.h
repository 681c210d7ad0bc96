// The words, numbers and symbols of Netgen's rule files.
#pragma once

#include <string_view>
#include <vector>

#include "dsl/text/source_text.h"

namespace af2::dsl {

enum class RlsTokenKind { Word, Number, String, Sign, End };

struct RlsToken {
  RlsTokenKind kind = RlsTokenKind::End;
  std::string_view text;
  Span span;
  /// Keywords may be written in any case; `other` is in lower case.
  bool is(std::string_view other) const;
};

/// The tokens of a text; the last one is an End. Spaces are left out, and so are comments (`#`,
/// `//` or `%` up to the end of the line). Never fails: any other character is a Sign.
///
/// comments  the comments are added to it, unless it is null
std::vector<RlsToken> rlsTokensOf(std::string_view text, std::vector<Span>* comments = nullptr);

}  // namespace af2::dsl
