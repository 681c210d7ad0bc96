#include "geometry/occ/step/step_omissions.h"

#include <cctype>
#include <string_view>

#include "geometry/base/words.h"

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

/// Or something in a string looks like it.
bool mayOmitNames(std::string_view text) {
  for (std::size_t at = text.find(kNamed); at != std::string_view::npos;
       at = text.find(kNamed, at + 1))
    if (omittedAt(text, at)) return true;
  return false;
}

}  // namespace

std::optional<std::string> withOmittedNames(const std::filesystem::path& path) {
  const std::string text = contentOf(path);
  if (!mayOmitNames(text)) return std::nullopt;
  std::string mended;
  std::size_t copied = 0;
  bool isInString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\'') isInString = !isInString;
    if (isInString || text[i] != kNamed.front()) continue;
    const auto place = omittedAt(text, i);
    if (!place) continue;
    mended.append(text, copied, *place - copied).append("''");
    copied = *place;
  }
  if (copied == 0) return std::nullopt;
  return mended.append(text, copied);
}

}  // namespace af2::geometry
