// Text files as words and numbers, one after the other.
// Not installed.
#pragma once

#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

/// The characters that separate words.
inline constexpr std::string_view kBlanks = " \t\r\n\f\v";

/// The bytes of a file. Throws InputError if it is a folder or cannot be opened.
std::string contentOf(const std::filesystem::path& path);

/// The words of a text, as views into it.
std::vector<std::string_view> wordsIn(std::string_view text, std::string_view blanks = kBlanks);

/// A text without the blanks at its ends.
std::string_view trimmed(std::string_view text);

/// "a, b or c", with `conjunction` before the last one.
std::string listed(const std::vector<std::string_view>& words, std::string_view conjunction);

/// The number that a word represents, perhaps with a leading plus; none if the whole word is not
/// such a number.
template <class Number>
std::optional<Number> numberIn(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// Reads the words of a text and keeps track of the line. The text must outlive it.
class Words {
 public:
  /// name  of the file, for messages
  Words(std::string name, std::string_view text) : name_(std::move(name)), text_(text) {}

  /// Empty at the end of the text.
  std::string_view next();
  /// The next word (or the next three) as finite numbers.
  double number();
  Point3 point();

  /// Goes to the end of the line.
  void skipLine();
  /// The rest of the line, with the lines that continue it after a backslash.
  std::string_view restOfLine();

  /// Throws InputError with file and line.
  [[noreturn]] void fail(const std::string& fault) const;

 private:
  std::string name_;
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace af2::geometry
