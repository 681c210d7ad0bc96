#include "dsl/netgen/rls_tokens.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "dsl/text/characters.h"

namespace af2::dsl {
namespace {

bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

bool beginsComment(std::string_view text) {
  return text.starts_with('#') || text.starts_with('%') || text.starts_with("//");
}

std::size_t numberLength(std::string_view text) {
  std::size_t i = 0;
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
  const std::size_t first = i;
  bool hasPoint = false;
  while (i < text.size() && (isDigit(text[i]) || (text[i] == '.' && !hasPoint)))
    hasPoint |= text[i++] == '.';
  if (i - first == (hasPoint ? 1u : 0u)) return 0;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t j = i + 1;
    if (j < text.size() && (text[j] == '-' || text[j] == '+')) ++j;
    const std::size_t digits = j;
    while (j < text.size() && isDigit(text[j])) ++j;
    if (j > digits) i = j;
  }
  return i;
}

}  // namespace

bool RlsToken::is(std::string_view other) const {
  return kind != RlsTokenKind::String &&
         std::equal(text.begin(), text.end(), other.begin(), other.end(), [](char one, char two) {
           return std::tolower(static_cast<unsigned char>(one)) == two;
         });
}

std::vector<RlsToken> rlsTokensOf(std::string_view text, std::vector<Span>* comments) {
  using Kind = RlsTokenKind;
  std::vector<RlsToken> tokens;
  std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const auto add = [&](Kind kind, std::size_t length) {
    tokens.push_back({kind,
                      text.substr(i, length),
                      {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + length)}});
    i += length;
  };
  while (i < text.size()) {
    if (isSpace(text[i])) {
      ++i;
    } else if (beginsComment(text.substr(i))) {
      const std::size_t end = std::min(text.find_first_of("\r\n", i), text.size());
      if (comments)
        comments->push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(end)});
      i = end;
    } else if (text[i] == '"') {
      const std::size_t close = text.find_first_of("\"\n", i + 1);
      const bool isClosed = close != std::string_view::npos && text[close] == '"';
      const std::size_t end = close == std::string_view::npos ? text.size() : close;
      isClosed ? add(Kind::String, end + 1 - i) : add(Kind::Sign, 1);
    } else if (const std::size_t number = numberLength(text.substr(i))) {
      add(Kind::Number, number);
    } else if (isNameStart(text[i])) {
      std::size_t end = i;
      while (end < text.size() && isNamePart(text[end])) ++end;
      add(Kind::Word, end - i);
    } else {
      add(Kind::Sign, 1);
    }
  }
  const auto end = static_cast<std::uint32_t>(text.size());
  tokens.push_back({Kind::End, {}, {end, end}});
  return tokens;
}

}  // namespace af2::dsl
