#include "geometry/base/utf8.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace af2::geometry {

namespace {

/// Where the first byte is, from `at` on, that is not ASCII; or the end.
std::size_t endOfAscii(std::string_view text, std::size_t at) {
  constexpr std::uint64_t kHighBits = 0x8080808080808080;
  std::uint64_t bytes = 0;
  for (; text.size() - at >= sizeof(bytes); at += sizeof(bytes)) {
    std::memcpy(&bytes, text.data() + at, sizeof(bytes));
    if (bytes & kHighBits) break;
  }
  while (at < text.size() && static_cast<unsigned char>(text[at]) < 0x80) ++at;
  return at;
}

}  // namespace

/// Follows the table of well-formed sequences in the Unicode Standard.
bool isUtf8(std::string_view text) {
  constexpr unsigned char kFirst = 0x80, kLast = 0xbf;  // of the bytes that follow the first
  for (std::size_t at = endOfAscii(text, 0); at < text.size(); at = endOfAscii(text, at)) {
    const auto first = static_cast<unsigned char>(text[at]);
    if (first < 0xc2 || first > 0xf4) return false;
    const std::size_t following = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
    unsigned char least = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : kFirst;
    unsigned char most = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : kLast;
    if (text.size() - at <= following) return false;
    for (std::size_t k = 1; k <= following; ++k) {
      const auto byte = static_cast<unsigned char>(text[at + k]);
      if (byte < least || byte > most) return false;
      least = kFirst;
      most = kLast;
    }
    at += following + 1;
  }
  return true;
}

}  // namespace af2::geometry
