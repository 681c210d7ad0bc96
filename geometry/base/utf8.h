// Whether text is UTF-8.
#pragma once

#include <filesystem>
#include <string_view>

namespace af2::geometry {

/// Takes text in pieces, which may end within a character.
class Utf8Check {
 public:
  void take(std::string_view text);
  /// Of all that was taken.
  bool isUtf8() const { return isValid_ && missing_ == 0; }

 private:
  void take(unsigned char byte);

  bool isValid_ = true;
  int missing_ = 0;                        ///< bytes of the character that was begun
  unsigned char least_ = 0, most_ = 0xff;  ///< that the next of these may be
};

/// False if it cannot be read.
bool isUtf8File(const std::filesystem::path& path);

}  // namespace af2::geometry
