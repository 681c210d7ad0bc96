#include "geometry/io/base64.h"

#include <algorithm>

namespace af2::geometry {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The two digits of twelve bits.
constexpr auto kPairs = [] {
  std::array<std::array<char, 2>, std::size_t{1} << 12> pairs{};
  for (std::size_t bits = 0; bits < pairs.size(); ++bits)
    pairs[bits] = {kDigits[bits >> 6], kDigits[bits & 63]};
  return pairs;
}();

}  // namespace

void Base64Stream::encodeGroups() {
  constexpr std::size_t kDigitsOfGroup = 4;
  std::array<char, kBlock / kGroup * kDigitsOfGroup> digits;
  const std::size_t groups = used_ / kGroup, encoded = groups * kGroup;
  for (std::size_t i = 0; i < groups; ++i) {
    const unsigned char* const group = bytes_.data() + kGroup * i;
    const std::uint32_t bits =
        std::uint32_t{group[0]} << 16 | std::uint32_t{group[1]} << 8 | std::uint32_t{group[2]};
    char* const to = digits.data() + kDigitsOfGroup * i;
    std::memcpy(to, kPairs[bits >> 12].data(), 2);
    std::memcpy(to + 2, kPairs[bits & 0xfff].data(), 2);
  }
  file_.bytes(digits.data(), groups * kDigitsOfGroup);
  std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(encoded),
            bytes_.begin() + static_cast<std::ptrdiff_t>(used_), bytes_.begin());
  used_ -= encoded;
}

void Base64Stream::finish() {
  encodeGroups();
  if (used_ == 0) return;
  const std::size_t missing = kGroup - used_;
  for (std::size_t i = 0; i < missing; ++i) bytes_[used_++] = 0;
  const std::uint32_t bits =
      std::uint32_t{bytes_[0]} << 16 | std::uint32_t{bytes_[1]} << 8 | std::uint32_t{bytes_[2]};
  const std::array<char, 4> digits{kDigits[bits >> 18], kDigits[bits >> 12 & 63],
                                   missing == 2 ? '=' : kDigits[bits >> 6 & 63], '='};
  file_.bytes(digits.data(), digits.size());
  used_ = 0;
}

}  // namespace af2::geometry
