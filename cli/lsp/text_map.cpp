#include "cli/lsp/text_map.h"

#include <algorithm>

namespace af2::lsp {
namespace {

/// Number of bytes of the character that begins with `c`.
std::size_t lengthOf(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte < 0xC0) return 1;
  if (byte < 0xE0) return 2;
  return byte < 0xF0 ? 3 : 4;
}

/// Throws RequestError unless it is a nonnegative integer.
std::size_t countIn(const Json& number) {
  const bool isCount = number.is_number_unsigned() ||
                       (number.is_number_integer() && number.get<std::int64_t>() >= 0);
  if (!isCount)
    throw RequestError(ErrorCode::InvalidParams,
                       "a position consists of whole numbers that count from 0");
  return number.get<std::size_t>();
}

/// Number of encoding units of a character with this many bytes.
std::size_t unitsOf(std::size_t bytes, Encoding encoding) {
  switch (encoding) {
    case Encoding::Utf8:
      return bytes;
    case Encoding::Utf16:
      return bytes == 4 ? 2 : 1;
    case Encoding::Utf32:
      return 1;
  }
  return 1;
}

}  // namespace

TextMap::TextMap(std::string_view text, Encoding encoding)
    : text_(text), encoding_(encoding), starts_{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isBreak =
        text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'));
    if (isBreak) starts_.push_back(static_cast<std::uint32_t>(i + 1));
  }
}

std::size_t TextMap::lineOf(std::uint32_t offset) const {
  const auto next = std::upper_bound(starts_.begin(), starts_.end(), offset);
  return static_cast<std::size_t>(next - starts_.begin()) - 1;
}

std::uint32_t TextMap::startOf(std::size_t line) const {
  return line < starts_.size() ? starts_[line] : static_cast<std::uint32_t>(text_.size());
}

std::string_view TextMap::line(std::size_t number) const {
  std::string_view text = text_.substr(startOf(number), startOf(number + 1) - startOf(number));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

Json TextMap::position(std::uint32_t offset) const {
  offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
  const std::size_t line = lineOf(offset);
  std::size_t column = 0;
  for (std::size_t i = starts_[line]; i < offset;) {
    const std::size_t bytes = std::min(lengthOf(text_[i]), offset - i);
    column += unitsOf(bytes, encoding_);
    i += bytes;
  }
  return {{"line", line}, {"character", column}};
}

Json TextMap::range(dsl::Span span) const {
  return {{"start", position(span.begin)}, {"end", position(std::max(span.begin, span.end))}};
}

std::uint32_t TextMap::offset(const Json& position) const {
  const std::size_t number = countIn(position.at("line"));
  const std::size_t wanted = countIn(position.at("character"));
  if (number >= starts_.size()) return static_cast<std::uint32_t>(text_.size());
  const std::string_view text = this->line(number);
  std::size_t at = 0, column = 0;
  while (at < text.size()) {
    const std::size_t bytes = std::min(lengthOf(text[at]), text.size() - at);
    column += unitsOf(bytes, encoding_);
    if (column > wanted) break;
    at += bytes;
  }
  return starts_[number] + static_cast<std::uint32_t>(at);
}

dsl::Span TextMap::span(const Json& range) const {
  const std::uint32_t a = offset(range.at("start")), b = offset(range.at("end"));
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace af2::lsp
