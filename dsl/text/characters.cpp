#include "dsl/text/characters.h"

#include <algorithm>
#include <array>

namespace af2::dsl {
namespace {

constexpr std::array kLookAlikes{
    LookAlike{"\u201C", "\"", "a typographic quote"},
    LookAlike{"\u201D", "\"", "a typographic quote"},
    LookAlike{"\u201E", "\"", "a typographic quote"},
    LookAlike{"\u00AB", "\"", "a typographic quote"},
    LookAlike{"\u00BB", "\"", "a typographic quote"},
    LookAlike{"\u2018", "'", "a typographic quote"},
    LookAlike{"\u2019", "'", "a typographic quote"},
    LookAlike{"\u2212", "-", "a minus sign from outside of ASCII"},
    LookAlike{"\u2010", "-", "a hyphen from outside of ASCII"},
    LookAlike{"\u2011", "-", "a hyphen from outside of ASCII"},
    LookAlike{"\u2013", "-", "a dash"},
    LookAlike{"\u2014", "-", "a dash"},
    LookAlike{"\u00D7", "*", ""},
    LookAlike{"\u00B7", "*", ""},
    LookAlike{"\u22C5", "*", ""},
    LookAlike{"\u00F7", "/", ""},
    LookAlike{"\u2215", "/", ""},
    LookAlike{"\u2264", "<=", ""},
    LookAlike{"\u2265", ">=", ""},
    LookAlike{"\u2260", "!=", ""},
    LookAlike{"\u2192", "->", ""},
    LookAlike{"\u27F6", "->", ""},
    LookAlike{"\u21D2", "=>", ""},
    LookAlike{"\u27F9", "=>", ""},
    LookAlike{"\u2026", "..", ""},
    LookAlike{"\u00B0", "deg", ""},
    LookAlike{"\u2227", "and", ""},
    LookAlike{"\u2228", "or", ""},
    LookAlike{"\u00AC", "not", ""},
    LookAlike{"\u222A", "|", ""},
    LookAlike{"\u2229", "&", ""},
    LookAlike{"\u223C", "~", ""},
    LookAlike{"\u02DC", "~", ""},
    LookAlike{"\uFF08", "(", ""},
    LookAlike{"\uFF09", ")", ""},
    LookAlike{"\uFF0C", ",", ""},
    LookAlike{"\uFF1B", ";", ""},
    LookAlike{"\uFF1D", "=", ""},
    LookAlike{"\uFF5B", "{", ""},
    LookAlike{"\uFF5D", "}", ""},
    LookAlike{"\u037E", ";", "a Greek question mark"},
    LookAlike{"\u00A0", " ", "a no-break space"},
    LookAlike{"\u202F", " ", "a no-break space"},
    LookAlike{"\u2009", " ", "a thin space"},
    LookAlike{"\u3000", " ", "a wide space"},
    LookAlike{"\u200B", " ", "a space without width"},
    LookAlike{"\uFEFF", " ", "a byte order mark"},
};

struct Twin {
  std::string_view written;
  char meant;
};

/// Letters that look the same as ASCII letters in every font: Cyrillic, then Greek.
constexpr std::array kTwins{
    Twin{"\u0430", 'a'}, Twin{"\u0441", 'c'}, Twin{"\u0435", 'e'}, Twin{"\u043E", 'o'},
    Twin{"\u0440", 'p'}, Twin{"\u0445", 'x'}, Twin{"\u0443", 'y'}, Twin{"\u0456", 'i'},
    Twin{"\u0458", 'j'}, Twin{"\u0455", 's'}, Twin{"\u0501", 'd'}, Twin{"\u051B", 'q'},
    Twin{"\u04BB", 'h'}, Twin{"\u0410", 'A'}, Twin{"\u0412", 'B'}, Twin{"\u0421", 'C'},
    Twin{"\u0415", 'E'}, Twin{"\u041D", 'H'}, Twin{"\u0406", 'I'}, Twin{"\u0408", 'J'},
    Twin{"\u041A", 'K'}, Twin{"\u041C", 'M'}, Twin{"\u041E", 'O'}, Twin{"\u0420", 'P'},
    Twin{"\u0405", 'S'}, Twin{"\u0422", 'T'}, Twin{"\u0425", 'X'}, Twin{"\u0423", 'Y'},
    Twin{"\u03BF", 'o'}, Twin{"\u03BD", 'v'}, Twin{"\u0391", 'A'}, Twin{"\u0392", 'B'},
    Twin{"\u0395", 'E'}, Twin{"\u0396", 'Z'}, Twin{"\u0397", 'H'}, Twin{"\u0399", 'I'},
    Twin{"\u039A", 'K'}, Twin{"\u039C", 'M'}, Twin{"\u039D", 'N'}, Twin{"\u039F", 'O'},
    Twin{"\u03A1", 'P'}, Twin{"\u03A4", 'T'}, Twin{"\u03A5", 'Y'}, Twin{"\u03A7", 'X'},
};

bool isTrail(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Whether `second` may follow `first` in a character of three or four bytes. This excludes
/// overlong encodings, halves of a UTF-16 surrogate pair, and code points beyond U+10FFFF.
bool isAllowedSecond(unsigned char lead, unsigned char second) {
  switch (lead) {
    case 0xE0:
      return second >= 0xA0;
    case 0xED:
      return second <= 0x9F;
    case 0xF0:
      return second >= 0x90;
    case 0xF4:
      return second <= 0x8F;
    default:
      return true;
  }
}

/// 0 if the text does not begin with a well-formed character.
std::size_t wellFormedSize(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t size = lead < 0x80                    ? 1
                           : lead >= 0xC2 && lead <= 0xDF ? 2
                           : lead >= 0xE0 && lead <= 0xEF ? 3
                           : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                          : 0;
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if (!isTrail(text[i])) return 0;
  return size < 3 || isAllowedSecond(lead, static_cast<unsigned char>(text[1])) ? size : 0;
}

bool isControl(char c) {
  const auto u = static_cast<unsigned char>(c);
  return (u < 0x20 && c != '\t' && c != '\n' && c != '\r') || u == 0x7F;
}

/// Some editors write UTF-16, with or without a byte order mark.
bool isUtf16(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return true;
  const std::string_view sample = text.substr(0, 1000);
  const auto zeros = static_cast<std::size_t>(std::ranges::count(sample, '\0'));
  return sample.size() >= 8 && 5 * zeros > 2 * sample.size() && 5 * zeros < 3 * sample.size();
}

std::size_t firstMalformed(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = wellFormedSize(text.substr(at));
    if (size == 0) return at;
    at += size;
  }
  return text.size();
}

}  // namespace

bool isPlainName(std::string_view text) {
  return !text.empty() && isNameStart(text[0]) && std::ranges::all_of(text, isNamePart);
}

const LookAlike* lookAlikeAt(std::string_view text) {
  if (text.empty() || static_cast<unsigned char>(text[0]) < 0x80) return nullptr;
  const auto found = std::ranges::find_if(
      kLookAlikes, [&](const LookAlike& l) { return text.starts_with(l.written); });
  return found == kLookAlikes.end() ? nullptr : &*found;
}

std::size_t characterSize(std::string_view text) {
  return std::max<std::size_t>(1, wellFormedSize(text));
}

bool beginsWithForeignLetter(std::string_view text) {
  if (text.empty() || lookAlikeAt(text)) return false;
  const auto lead = static_cast<unsigned char>(text[0]);
  // Latin, Greek, Cyrillic and so on up to U+1FFF, and the scripts of East Asia.
  const bool isLow = lead >= 0xC3 && lead <= 0xE1;
  const bool isEastern = lead >= 0xE3 && lead <= 0xED;
  return (isLow || isEastern) && wellFormedSize(text) > 0;
}

std::optional<std::string> plainSpelling(std::string_view name) {
  std::string plain;
  while (!name.empty()) {
    const std::size_t size = characterSize(name);
    const auto twin = std::ranges::find(kTwins, name.substr(0, size), &Twin::written);
    if (size > 1 && twin == kTwins.end()) return std::nullopt;
    plain += size > 1 ? twin->meant : name[0];
    name.remove_prefix(size);
  }
  return plain;
}

std::optional<UnreadableText> findUnreadable(std::string_view text) {
  if (isUtf16(text))
    return UnreadableText{0, 0, "this file is written in UTF-16", "save it as UTF-8"};
  // A single control character is reported at its place; a file with many of them is not text.
  const std::string_view sample = text.substr(0, 4000);
  const auto controls = static_cast<std::size_t>(std::ranges::count_if(sample, isControl));
  if (controls >= 5 && 50 * controls > sample.size())
    return UnreadableText{0, 0, "this is not a text file", "a rule file is plain text"};
  const std::size_t carriageReturn = text.find('\r');
  if (carriageReturn != text.npos && text.find('\n') == text.npos)
    return UnreadableText{carriageReturn, carriageReturn + 1,
                          "the lines of this file end in a carriage return alone",
                          "save it with line feeds (LF or CRLF)"};
  const std::size_t malformed = firstMalformed(text);
  if (malformed < text.size())
    return UnreadableText{malformed, malformed + 1, "this file is not UTF-8",
                          "save it as UTF-8; this character is written in another encoding", false};
  return std::nullopt;
}

bool isMalformedCharacter(std::string_view text) {
  return static_cast<unsigned char>(text[0]) >= 0x80 && characterSize(text) == 1;
}

std::string shownUnknown(std::string_view written) {
  constexpr std::size_t kMost = 24;
  std::string result = "'";
  for (char c : written.substr(0, kMost))
    result += static_cast<unsigned char>(c) >= 0x20 && c != 0x7f ? c : '?';
  return result + "'";
}

std::string helpForUnknown(std::string_view written) {
  if (written[0] == '!') return "write `not` for the opposite, `!=` for unequal";
  if (written[0] == '?') return "a choice is written `if condition then x else y`";
  if (written[0] == '%') return "there is no remainder operator; `%` has no meaning here";
  if (written[0] == '\'') return "write strings in double quotes";
  return "delete it; the language uses plain ASCII outside of strings and comments";
}

}  // namespace af2::dsl
