// Text files of numbers, line by line. Not installed.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/error.h"
#include "geometry/base/words.h"

namespace af2::geometry {

inline constexpr long kMaxItems = 100'000'000;

/// The lines of a file that are not empty, as words; `#` starts a comment.
class WordFile {
 public:
  explicit WordFile(const std::filesystem::path& path)
      : name_(path.string()), text_(contentOf(path)) {}
  WordFile(const WordFile&) = delete;  // the words are parts of its text
  WordFile& operator=(const WordFile&) = delete;

  /// Goes to the next line with words; false at the end of the file.
  bool next() {
    words_.clear();
    while (words_.empty() && at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      split(std::string_view(text_).substr(at_, end - at_));
      at_ = end + 1;
      ++line_;
    }
    if (words_.empty()) ++line_;
    return !words_.empty();
  }
  void expectLine(const std::string& what) {
    if (!next()) fail("the file ends before " + what);
  }

  std::size_t count() const { return words_.size(); }
  std::string_view word(std::size_t i) const { return words_[i]; }
  int line() const { return line_; }

  double number(std::size_t i, const std::string& what) const {
    const auto value = numberIn<double>(at(i, what));
    if (!value || !std::isfinite(*value))
      fail("'" + std::string(word(i)) + "' is not a number; expected " + what);
    return *value;
  }
  long whole(std::size_t i, const std::string& what) const {
    const double value = number(i, what);
    if (value != std::floor(value) || std::abs(value) > static_cast<double>(kMaxItems))
      fail("'" + std::string(at(i, what)) + "' is no " + what);
    return static_cast<long>(value);
  }
  long countAt(std::size_t i, const std::string& what) const {
    const long value = whole(i, what);
    if (value < 0) fail("the " + what + " is negative");
    return value;
  }

  [[noreturn]] void fail(const std::string& fault) const {
    throw InputError(name_ + ":" + std::to_string(line_) + ": " + fault);
  }

 private:
  std::string_view at(std::size_t i, const std::string& what) const {
    if (i >= words_.size()) fail("the line is too short; " + what + " is missing");
    return words_[i];
  }
  void split(std::string_view line) {
    static constexpr std::string_view kBetween = " \t\r\f\v,";
    words_ = wordsIn(line.substr(0, line.find('#')), kBetween);
  }

  std::string name_, text_;
  std::size_t at_ = 0;  // where the next line begins
  std::vector<std::string_view> words_;
  int line_ = 0;
};

}  // namespace af2::geometry
