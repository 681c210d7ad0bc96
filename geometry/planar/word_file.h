// Text files of numbers, line by line. Not installed.
#pragma once

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/error.h"

namespace af2::geometry {

inline constexpr long kMostItems = 100'000'000;

/// The lines of a file that hold something, as words; `#` starts a comment.
class WordFile {
 public:
  explicit WordFile(const std::filesystem::path& path) : name_(path.string()), stream_(path) {
    if (std::filesystem::is_directory(path)) throw InputError(name_ + ": is a folder, not a file");
    if (!stream_) throw InputError(name_ + ": cannot be opened; check that it exists");
  }

  /// Goes to the next line with words; false at the end of the file.
  bool next() {
    while (std::getline(stream_, text_)) {
      ++line_;
      split();
      if (!words_.empty()) return true;
    }
    ++line_;
    words_.clear();
    return false;
  }
  void expectLine(const std::string& what) {
    if (!next()) fail("the file ends where " + what + " should follow");
  }

  std::size_t count() const { return words_.size(); }
  std::string_view word(std::size_t i) const { return words_[i]; }
  int line() const { return line_; }

  double number(std::size_t i, const std::string& what) const {
    double value = 0;
    const std::string_view word = at(i, what);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      fail("'" + std::string(word) + "' is no number; " + what + " should stand here");
    return value;
  }
  long whole(std::size_t i, const std::string& what) const {
    const double value = number(i, what);
    if (value != std::floor(value) || std::abs(value) > static_cast<double>(kMostItems))
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
    std::string_view word = words_[i];
    if (word.starts_with('+')) word.remove_prefix(1);
    return word;
  }
  void split() {
    words_.clear();
    const std::string_view text = std::string_view(text_).substr(0, text_.find('#'));
    constexpr std::string_view kBlank = " \t\r\f\v,";
    for (std::size_t i = text.find_first_not_of(kBlank); i != std::string_view::npos;) {
      const std::size_t end = std::min(text.find_first_of(kBlank, i), text.size());
      words_.push_back(text.substr(i, end - i));
      i = text.find_first_not_of(kBlank, end);
    }
  }

  std::string name_;
  std::ifstream stream_;
  std::string text_;
  std::vector<std::string_view> words_;
  int line_ = 0;
};

}  // namespace af2::geometry
