// Files in which text and binary numbers alternate.
// Not installed.
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/base/words.h"

namespace af2::geometry {

/// How numbers are written.
enum class Coding { Text, LowFirst, HighFirst };

class NumberStream {
 public:
  /// name  of the file, for messages; `data` must outlive the stream
  NumberStream(std::string name, std::string_view data) : name_(std::move(name)), data_(data) {}

  bool isAtEnd() const { return at_ == data_.size(); }
  /// The next word of a text; empty at the end.
  std::string_view word();
  /// The next word, which must not be the end; `what` says what it should be.
  std::string_view word(const char* what);
  /// The rest of the line, without its end; goes to the next line.
  std::string_view line();
  /// Goes to the place behind the next occurrence of `mark`. Fails if there is none.
  void skipPast(std::string_view mark);

  template <class Number>
  Number number(Coding coding) {
    if (coding == Coding::Text) return textNumber<Number>();
    if (data_.size() - at_ < sizeof(Number)) failTruncated();
    char bytes[sizeof(Number)];
    std::memcpy(bytes, data_.data() + at_, sizeof bytes);
    if (coding == Coding::HighFirst) std::reverse(bytes, bytes + sizeof bytes);
    at_ += sizeof bytes;
    return std::bit_cast<Number>(bytes);
  }
  /// A number of things that follow, each with at least one byte: a wrong number cannot make the
  /// reader ask for more memory than the file has.
  template <std::integral Number>
  std::size_t count(Coding coding) {
    const Number value = number<Number>(coding);
    if (std::cmp_less(value, 0)) fail("a count is negative: " + std::to_string(value));
    if (std::cmp_greater(value, data_.size() - at_)) failTruncated();
    return static_cast<std::size_t>(value);
  }

  /// Throws InputError with the file and the line, or the byte of a binary file.
  [[noreturn]] void fail(const std::string& fault) const;
  [[noreturn]] void failTruncated() const;

 private:
  template <class Number>
  Number textNumber() {
    const std::string_view text = word();
    if (text.empty()) failTruncated();
    const auto value = numberIn<Number>(text);
    if (!value)
      fail("'" + std::string(text.substr(0, 40)) + "' is not a number of the kind expected");
    return *value;
  }

  std::string name_;
  std::string_view data_;
  std::size_t at_ = 0;
};

}  // namespace af2::geometry
