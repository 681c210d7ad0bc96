// Positions in a text as editors count them: lines and columns from 0, columns in units of an
// encoding.
#pragma once

#include <string_view>
#include <vector>

#include "cli/lsp/json_rpc.h"
#include "dsl/text/source_text.h"

namespace af2::lsp {

enum class Encoding { Utf8, Utf16, Utf32 };

/// The lines of a text, which must outlive this object.
class TextMap {
 public:
  TextMap(std::string_view text, Encoding encoding);

  /// `{line, character}` of a byte.
  Json position(std::uint32_t offset) const;
  /// `{start, end}` of a span.
  Json range(dsl::Span span) const;
  /// The byte at a position; beyond the end of a line, the end of the line, as the protocol
  /// requires.
  std::uint32_t offset(const Json& position) const;
  dsl::Span span(const Json& range) const;

  std::size_t lineCount() const { return starts_.size(); }
  std::size_t lineOf(std::uint32_t offset) const;
  /// The byte where a line begins; beyond the last line, the end of the text.
  std::uint32_t startOf(std::size_t line) const;
  /// A line without its line break.
  std::string_view line(std::size_t number) const;

 private:
  std::string_view text_;
  Encoding encoding_;
  std::vector<std::uint32_t> starts_;  ///< lines end in \n, \r\n or \r
};

}  // namespace af2::lsp
