// Characters of names and numbers, look-alikes of ASCII characters, and unreadable text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace af2::dsl {

constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
/// Whether a name of the language may begin with a character, and whether it may contain it
/// elsewhere.
constexpr bool isNameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool isNamePart(char c) { return isNameStart(c) || isDigit(c); }
/// Whether a text has the form of a name. Reserved words have this form, too.
bool isPlainName(std::string_view text);

/// A character from a word processor or another alphabet that stands for an ASCII character.
struct LookAlike {
  std::string_view written;  ///< in UTF-8
  std::string_view meant;    ///< a word of the language, `"`, `'`, or a blank
  std::string_view name;     ///< its usual name; empty if the character is clear as it is
};

/// The look-alike with which `text` begins, or null.
const LookAlike* lookAlikeAt(std::string_view text);

/// Number of bytes of the character with which `text` begins: at least 1, even if it is malformed.
std::size_t characterSize(std::string_view text);

/// Whether `text` begins with a byte that is no character in UTF-8.
bool isMalformedCharacter(std::string_view text);

/// Characters that the language does not know, in quotes, without those that cannot be printed; and
/// what to write instead.
std::string shownUnknown(std::string_view written);
std::string helpForUnknown(std::string_view written);

/// Whether `text` begins with a letter that is not ASCII, as in names of other languages.
bool beginsWithForeignLetter(std::string_view text);

/// The name with each look-alike from another alphabet replaced by its ASCII letter. Returns
/// nothing if the name also contains other letters outside of ASCII.
std::optional<std::string> plainSpelling(std::string_view name);

/// Why a file, or a part of it, cannot be read as text.
struct UnreadableText {
  std::size_t from = 0, to = 0;
  std::string fault, help;
  bool isHopeless = true;  ///< the rest of the file cannot be read either
};
std::optional<UnreadableText> findUnreadable(std::string_view text);

}  // namespace af2::dsl
