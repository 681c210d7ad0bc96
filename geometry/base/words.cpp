#include "geometry/base/words.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "engine/base/error.h"
#include "engine/base/stream_text.h"

namespace af2::geometry {
namespace {

bool endsInBackslash(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line.ends_with('\\');
}

}  // namespace

std::string contentOf(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(path.string() + ": is a folder, not a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string() + ": cannot be opened; check that it exists");
  return restOf(stream);
}

std::vector<std::string_view> wordsIn(std::string_view text, std::string_view blanks) {
  std::vector<std::string_view> words;
  for (std::size_t i = text.find_first_not_of(blanks); i != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, i), text.size());
    words.push_back(text.substr(i, end - i));
    i = text.find_first_not_of(blanks, end);
  }
  return words;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string listed(const std::vector<std::string_view>& words, std::string_view conjunction) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? ", " : " " + std::string(conjunction) + " ";
    text += words[i];
  }
  return text;
}

std::string_view Words::next() {
  const std::size_t first = std::min(text_.find_first_not_of(kBlanks, at_), text_.size());
  line_ += static_cast<int>(std::ranges::count(text_.substr(at_, first - at_), '\n'));
  at_ = std::min(text_.find_first_of(kBlanks, first), text_.size());
  return text_.substr(first, at_ - first);
}

double Words::number() {
  const std::string_view word = next();
  const auto value = numberIn<double>(word);
  if (!value || !std::isfinite(*value)) fail("'" + std::string(word) + "' is not a number");
  return *value;
}

Point3 Words::point() {
  const double x = number(), y = number(), z = number();
  return {x, y, z};
}

void Words::skipLine() { at_ = std::min(text_.find('\n', at_), text_.size()); }

std::string_view Words::restOfLine() {
  const std::size_t first = at_;
  skipLine();
  while (at_ < text_.size() && endsInBackslash(text_.substr(first, at_ - first))) {
    ++line_;
    ++at_;
    skipLine();
  }
  return text_.substr(first, at_ - first);
}

void Words::fail(const std::string& fault) const {
  throw InputError(name_ + ":" + std::to_string(line_) + ": " + fault);
}

}  // namespace af2::geometry
