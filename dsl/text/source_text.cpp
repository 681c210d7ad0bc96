#include "dsl/text/source_text.h"

#include <algorithm>

namespace af2::dsl {
namespace {

constexpr std::size_t kBlock = 1024;

/// Number of characters between two offsets; continuation bytes do not count.
std::uint32_t countCharacters(std::string_view text, std::size_t from, std::size_t to) {
  std::uint32_t count = 0;
  for (const char c : text.substr(from, to - from))
    count += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return count;
}

}  // namespace

SourceText::SourceText(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), lineStarts_{0}, characters_{0} {
  for (std::size_t at = kBlock; at <= text_.size(); at += kBlock)
    characters_.push_back(characters_.back() + countCharacters(text_, at - kBlock, at));
  for (std::size_t i = 0; i < text_.size(); ++i)
    if (text_[i] == '\n') lineStarts_.push_back(static_cast<std::uint32_t>(i + 1));
}

int SourceText::lineOf(std::uint32_t offset) const {
  const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), offset);
  return static_cast<int>(next - lineStarts_.begin());
}

std::uint32_t SourceText::charactersBefore(std::size_t offset) const {
  const std::size_t block = offset / kBlock;
  return characters_[block] + countCharacters(text_, block * kBlock, offset);
}

LinePlace SourceText::place(std::uint32_t offset) const {
  const int line = lineOf(offset);
  const std::size_t start = startOf(line);
  const std::size_t end = std::clamp<std::size_t>(offset, start, std::max(start, text_.size()));
  return {line, static_cast<int>(charactersBefore(end) - charactersBefore(start)) + 1};
}

std::uint32_t SourceText::offsetOf(LinePlace place) const {
  if (place.line < 1) return 0;
  if (static_cast<std::size_t>(place.line) > lineStarts_.size())
    return static_cast<std::uint32_t>(text_.size());
  std::uint32_t at = lineStarts_[static_cast<std::size_t>(place.line - 1)];
  for (int column = 1; column < place.column && at < text_.size() && text_[at] != '\n'; ++column) {
    ++at;
    while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xC0) == 0x80) ++at;
  }
  return at;
}

std::string_view SourceText::line(int number) const {
  if (number < 1 || static_cast<std::size_t>(number) > lineStarts_.size()) return {};
  const auto index = static_cast<std::size_t>(number);
  const std::size_t start = lineStarts_[index - 1];
  const std::size_t end = index < lineStarts_.size() ? lineStarts_[index] - 1 : text_.size();
  std::string_view rest = std::string_view(text_).substr(start, end - start);
  if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
  return rest;
}

}  // namespace af2::dsl
