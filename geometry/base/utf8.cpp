#include "geometry/base/utf8.h"

#include <array>
#include <fstream>

namespace af2::geometry {

void Utf8Check::take(std::string_view text) {
  for (const char c : text) take(static_cast<unsigned char>(c));
}

/// Follows the table of well-formed sequences in the Unicode Standard.
void Utf8Check::take(unsigned char byte) {
  constexpr unsigned char kFirst = 0x80, kLast = 0xbf;  // of the bytes that follow
  if (missing_ > 0) {
    isValid_ = isValid_ && byte >= least_ && byte <= most_;
    --missing_;
    least_ = kFirst;
    most_ = kLast;
    return;
  }
  if (byte < 0x80) return;
  isValid_ = isValid_ && byte >= 0xc2 && byte <= 0xf4;
  missing_ = byte >= 0xf0 ? 3 : byte >= 0xe0 ? 2 : 1;
  least_ = byte == 0xe0 ? 0xa0 : byte == 0xf0 ? 0x90 : kFirst;
  most_ = byte == 0xed ? 0x9f : byte == 0xf4 ? 0x8f : kLast;
}

bool isUtf8File(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return false;
  Utf8Check check;
  std::array<char, 1 << 16> buffer;
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    check.take({buffer.data(), static_cast<std::size_t>(stream.gcount())});
  }
  return check.isUtf8();
}

}  // namespace af2::geometry
