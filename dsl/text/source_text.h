// The text of one rule file, and how places in it are found again.
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

/// A half-open range of bytes of a text. An empty span at 0 stands for "nowhere in particular".
struct Span {
  std::uint32_t begin = 0, end = 0;
  bool operator==(const Span&) const = default;
};

/// The smallest span that holds both.
inline Span cover(Span a, Span b) {
  return {a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

/// A place as people count it: lines and columns from 1, columns in characters.
struct LinePlace {
  int line = 1, column = 1;
  bool operator==(const LinePlace&) const = default;
};

/// A named text with its lines. Immutable.
class AF2_EXPORT SourceText {
 public:
  SourceText(std::string name, std::string text);

  /// What the text is called in diagnostics: the path as the user gave it.
  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  LinePlace place(std::uint32_t offset) const;
  int lineOf(std::uint32_t offset) const;
  /// Offset of the first byte of a line that there is.
  std::uint32_t startOf(int line) const { return lineStarts_[static_cast<std::size_t>(line - 1)]; }
  /// The other way round: the byte at a place; the end of the line or of the text if it lies
  /// beyond.
  std::uint32_t offsetOf(LinePlace place) const;
  /// A line, counted from 1, without its line break. Empty beyond the last one.
  std::string_view line(int number) const;

 private:
  std::uint32_t charactersBefore(std::size_t offset) const;

  std::string name_, text_;
  std::vector<std::uint32_t> lineStarts_;
  std::vector<std::uint32_t> characters_;  ///< that begin before each block of the text
};

/// Where the text of a file is to be had before the disk is asked; nothing: ask the disk.
using TextSource = std::function<std::optional<std::string>(const std::filesystem::path&)>;

}  // namespace af2::dsl
