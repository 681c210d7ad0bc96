#include "geometry/reading/number_stream.h"

#include "engine/base/error.h"

namespace af2::geometry {

std::string_view NumberStream::word() {
  const std::size_t first = std::min(data_.find_first_not_of(kBlanks, at_), data_.size());
  at_ = std::min(data_.find_first_of(kBlanks, first), data_.size());
  return data_.substr(first, at_ - first);
}

std::string_view NumberStream::word(const char* what) {
  const std::string_view found = word();
  if (found.empty()) fail(std::string("the file ends where ") + what + " should follow");
  return found;
}

std::string_view NumberStream::line() {
  const std::size_t end = std::min(data_.find('\n', at_), data_.size());
  const std::string_view text = data_.substr(at_, end - at_);
  at_ = std::min(end + 1, data_.size());
  return text.ends_with('\r') ? text.substr(0, text.size() - 1) : text;
}

void NumberStream::skipPast(std::string_view mark) {
  const std::size_t found = data_.find(mark, at_);
  if (found == std::string_view::npos) failTruncated();
  at_ = found + mark.size();
}

void NumberStream::fail(const std::string& fault) const {
  const std::string_view before = data_.substr(0, at_);
  const bool isBinary = before.find('\0') != std::string_view::npos;
  throw InputError(name_ +
                   (isBinary ? ": byte " + std::to_string(at_)
                             : ":" + std::to_string(1 + std::ranges::count(before, '\n'))) +
                   ": " + fault);
}

void NumberStream::failTruncated() const {
  throw InputError(name_ + ": is truncated or damaged: more numbers should follow byte " +
                   std::to_string(at_) + "; write the file again");
}

}  // namespace af2::geometry
