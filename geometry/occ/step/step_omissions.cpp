#include "geometry/occ/step/step_omissions.h"

#include <cctype>
#include <optional>
#include <string_view>

namespace af2::geometry {

namespace {

/// Keywords of complex entities whose only parameter is a name.
constexpr std::string_view kNamed = "REPRESENTATION_ITEM";

bool isPartOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::size_t skipSpace(std::string_view text, std::size_t at) {
  while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at]))) ++at;
  return at;
}

/// Where the name of the keyword at `at` is to be put; nothing if it has one, or there is no such
/// keyword.
std::optional<std::size_t> omittedAt(std::string_view text, std::size_t at) {
  if (text.substr(at, kNamed.size()) != kNamed) return std::nullopt;
  if (at > 0 && isPartOfWord(text[at - 1])) return std::nullopt;
  const std::size_t open = skipSpace(text, at + kNamed.size());
  if (text.substr(open, 1) != "(") return std::nullopt;
  if (text.substr(skipSpace(text, open + 1), 1) != ")") return std::nullopt;
  return open + 1;
}

/// What is to be put in place of a part of the text.
struct Mend {
  std::size_t at = 0, length = 0;
  std::string_view by;
};

bool isDigitAt(std::string_view text, std::size_t at) {
  return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
}

/// If there is an exponent at `at`: its letter, with the point that a real must have.
std::optional<Mend> exponentAt(std::string_view text, std::size_t at) {
  const bool isSigned = text.substr(at + 1, 1) == "+" || text.substr(at + 1, 1) == "-";
  if (at == 0 || !isDigitAt(text, at + (isSigned ? 2 : 1))) return std::nullopt;
  if (text[at - 1] == '.')
    return isDigitAt(text, at - 2) ? std::optional(Mend{at, 1, "E"}) : std::nullopt;
  std::size_t first = at;
  while (first > 0 && isDigitAt(text, first - 1)) --first;
  if (first == at || (first > 0 && isPartOfWord(text[first - 1]))) return std::nullopt;
  return Mend{at, 1, first > 0 && text[first - 1] == '.' ? "E" : ".E"};
}

constexpr char kExponent = 'e';

std::optional<Mend> mendAt(std::string_view text, std::size_t at) {
  if (text[at] == kExponent) return exponentAt(text, at);
  if (text[at] != kNamed.front()) return std::nullopt;
  const auto place = omittedAt(text, at);
  return place ? std::optional(Mend{*place, 0, "''"}) : std::nullopt;
}

/// Or something in a string looks like it.
bool mayNeedMending(std::string_view text) {
  for (std::size_t at = text.find(kNamed); at != text.npos; at = text.find(kNamed, at + 1))
    if (omittedAt(text, at)) return true;
  for (std::size_t at = text.find(kExponent); at != text.npos; at = text.find(kExponent, at + 1))
    if (exponentAt(text, at)) return true;
  return false;
}

}  // namespace

void mendStepText(std::string& text) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  if (!mayNeedMending(text)) return;
  std::string mended;
  std::size_t copied = 0;
  bool isInString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\'') isInString = !isInString;
    if (isInString) continue;
    const auto mend = mendAt(text, i);
    if (!mend) continue;
    mended.append(text, copied, mend->at - copied).append(mend->by);
    copied = mend->at + mend->length;
  }
  text = mended.append(text, copied);
}

}  // namespace af2::geometry
