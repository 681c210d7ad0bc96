// The text of one rule file, with conversion between offsets and lines and columns.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/export.h"

namespace af2::dsl {

/// A half-open range of bytes of a text. An empty span at 0 means "no particular place".
struct Span {
  std::uint32_t begin = 0, end = 0;
  bool operator==(const Span&) const = default;
};

/// The smallest span that contains both.
inline Span cover(Span a, Span b) {
  return {a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

/// A place in lines and columns, both from 1. Columns count characters.
struct LinePlace {
  int line = 1, column = 1;
  bool operator==(const LinePlace&) const = default;
};

/// A named text with its lines. Immutable.
class AF2_EXPORT SourceText {
 public:
  SourceText(std::string name, std::string text);

  /// The name of the text in diagnostics: the path as the user gave it.
  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  LinePlace place(std::uint32_t offset) const;
  int lineOf(std::uint32_t offset) const;
  /// Offset of the first byte of a line. The line must exist.
  std::uint32_t startOf(int line) const { return lineStarts_[static_cast<std::size_t>(line - 1)]; }
  /// Offset of the byte at a place; the end of the line or of the text if the place is beyond it.
  std::uint32_t offsetOf(LinePlace place) const;
  /// A line, counted from 1, without its line break. Empty beyond the last one.
  std::string_view line(int number) const;

 private:
  std::uint32_t charactersBefore(std::size_t offset) const;

  std::string name_, text_;
  std::vector<std::uint32_t> lineStarts_;
  std::vector<std::uint32_t> characters_;  ///< number of characters before each block of the text
};

/// Supplies the text of a file in place of the disk; nothing means that the file is read from the
/// disk.
using TextSource = std::function<std::optional<std::string>(const std::filesystem::path&)>;

}  // namespace af2::dsl
