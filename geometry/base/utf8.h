// Whether text is UTF-8.
#pragma once

#include <filesystem>
#include <string_view>

namespace af2::geometry {

/// Checks text that comes in pieces, which may end within a character.
class Utf8Check {
 public:
  void take(std::string_view text);
  /// Whether all of the text so far is UTF-8.
  bool isUtf8() const { return isValid_ && missing_ == 0; }

 private:
  void take(unsigned char byte);

  bool isValid_ = true;
  int missing_ = 0;                        ///< bytes that the current character still lacks
  unsigned char least_ = 0, most_ = 0xff;  ///< bounds of the next byte
};

/// False if it cannot be read.
bool isUtf8File(const std::filesystem::path& path);

}  // namespace af2::geometry
