#include "geometry/occ/step/step_numbers.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace af2::geometry {

namespace {

class UnusableNumbers {
 public:
  explicit UnusableNumbers(std::string_view text) : text_(text) {}

  std::map<int, std::string> find() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\'') {
        at_ = std::min(text_.find('\'', at_ + 1), text_.size() - 1) + 1;
      } else if (c == '/' && text_.substr(at_, 2) == "/*") {
        at_ = std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2;
      } else if (c == '#') {
        readLabel();
      } else if (isDigit(c)) {
        readNumber();
      } else {
        isStart_ = c == ';' || (isStart_ && std::isspace(static_cast<unsigned char>(c)));
        ++at_;
      }
    }
    return std::move(found_);
  }

 private:
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }

  /// The first label of a statement names its entity.
  void readLabel() {
    int label = 0;
    const auto end =
        std::from_chars(text_.data() + at_ + 1, text_.data() + text_.size(), label).ptr;
    at_ = static_cast<std::size_t>(end - text_.data());
    if (isStart_) label_ = label;
    isStart_ = false;
  }

  void readNumber() {
    isStart_ = false;
    if (skipUsual()) return;
    constexpr double kHuge = 1e100;
    double value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    std::string_view number(begin, static_cast<std::size_t>(end - begin));
    const bool isTiny = number.find("E-") != number.npos || number.find("e-") != number.npos;
    const bool isTooLarge = value > kHuge || (error == std::errc::result_out_of_range && !isTiny);
    const bool isNone = text_.substr(at_ + number.size(), 1) == "#";
    if (isNone) number = text_.substr(at_, text_.find_first_of(",)", at_) - at_);
    if (isTooLarge || isNone) found_.try_emplace(label_, number);
    at_ += number.size();
  }

  /// Skips a number with few digits that is not raised to a positive power: most are such, and
  /// numbers take long to read.
  bool skipUsual() {
    constexpr std::size_t kFew = 100;
    const std::size_t after = std::min(text_.find_first_not_of("0123456789.", at_), text_.size());
    const std::string_view next = text_.substr(after, 2);
    const bool isRaised = next.starts_with('E') || next.starts_with('e');
    if (after - at_ >= kFew || next.starts_with('#') || (isRaised && !next.ends_with('-')))
      return false;
    at_ = after;
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int label_ = 0;
  bool isStart_ = true;  ///< nothing of the statement is read yet
  std::map<int, std::string> found_;
};

}  // namespace

std::map<int, std::string> unusableNumbersIn(std::string_view text) {
  return UnusableNumbers(text).find();
}

}  // namespace af2::geometry
