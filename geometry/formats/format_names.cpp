#include "geometry/formats/format_names.h"

#include <algorithm>
#include <string_view>

namespace af2::geometry {
namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool isInWord(char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; }

std::string wordOf(std::string_view name) {
  std::string word;
  for (const char c : name) {
    if (isInWord(c))
      word += c;
    else if (!word.empty() && word.back() != '_')
      word += '_';
  }
  while (word.ends_with('_')) word.pop_back();
  return !word.empty() && isLetter(word.front()) ? word : "group_" + word;
}

/// Cuts between characters of UTF-8.
std::string cut(std::string name, std::size_t longest) {
  if (name.size() <= longest) return name;
  while (longest > 0 && (static_cast<unsigned char>(name[longest]) & 0xc0) == 0x80) --longest;
  name.resize(longest);
  return name;
}

}  // namespace

std::string FormatNames::allowed(const std::string& name) const {
  if (limits_.isWord) return wordOf(name);
  std::string plain = name;
  std::ranges::replace_if(
      plain, [](unsigned char c) { return c < ' ' || c == '/'; }, '_');  // '/' divides HDF5's paths
  return plain;
}

bool FormatNames::take(const std::string& name) {
  std::string key = name;
  if (limits_.isWord)
    for (char& c : key)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return taken_.insert(key).second;
}

std::string FormatNames::add(const std::string& name) {
  const std::string plain = allowed(name);
  std::string result = cut(plain, limits_.longest);
  for (int count = 2; !take(result); ++count) {
    const std::string end = "_" + std::to_string(count);
    result = cut(plain, limits_.longest - end.size()) + end;
  }
  return result;
}

}  // namespace af2::geometry
