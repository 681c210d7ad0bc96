// What names and numbers are made of, characters beyond plain ASCII, and texts that are none.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace af2::dsl {

constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
/// Whether a name of the language may begin with a character, and have it elsewhere.
constexpr bool isNameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool isNamePart(char c) { return isNameStart(c) || isDigit(c); }
/// Whether a text is written as names of the language are; it may be a reserved word.
bool isPlainName(std::string_view text);

/// A character that word processors and other alphabets put where plain ASCII is meant.
struct LookAlike {
  std::string_view written;  ///< in UTF-8
  std::string_view meant;    ///< a word of the language, `"`, `'`, or a blank
  std::string_view name;     ///< what people call it; empty: it shows by itself
};

/// The look-alike with which `text` begins, or null.
const LookAlike* lookAlikeAt(std::string_view text);

/// Number of bytes of the character with which `text` begins, at least 1; also where it is
/// malformed.
std::size_t characterSize(std::string_view text);

/// Whether `text` begins with a letter that is not ASCII, as in names of other languages.
bool beginsWithForeignLetter(std::string_view text);

/// A name in which letters of other alphabets that look like ASCII ones are replaced by these;
/// nothing if it has others, too.
std::optional<std::string> plainSpelling(std::string_view name);

/// Why a file cannot be read as text, or not all of it.
struct UnreadableText {
  std::size_t from = 0, to = 0;
  std::string fault, help;
  bool isHopeless = true;  ///< reading on would only find garbage
};
std::optional<UnreadableText> findUnreadable(std::string_view text);

}  // namespace af2::dsl
