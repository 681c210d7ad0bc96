#include "dsl/source_text.h"

#include <algorithm>

namespace af2::dsl {

SourceText::SourceText(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), lineStarts_{0} {
  for (std::size_t i = 0; i < text_.size(); ++i)
    if (text_[i] == '\n') lineStarts_.push_back(static_cast<std::uint32_t>(i + 1));
}

int SourceText::lineOf(std::uint32_t offset) const {
  const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), offset);
  return static_cast<int>(next - lineStarts_.begin());
}

LinePlace SourceText::place(std::uint32_t offset) const {
  const int line = lineOf(offset);
  const std::uint32_t start = lineStarts_[static_cast<std::size_t>(line - 1)];
  int column = 1;
  for (std::uint32_t i = start; i < offset && i < text_.size(); ++i)
    column += (static_cast<unsigned char>(text_[i]) & 0xC0) != 0x80;  // not inside a character
  return {line, column};
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
  const std::size_t start = lineStarts_[static_cast<std::size_t>(number - 1)];
  std::string_view rest = std::string_view(text_).substr(start);
  rest = rest.substr(0, rest.find('\n'));
  if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
  return rest;
}

}  // namespace af2::dsl
