// Writes binary values as base64. Not installed.
#pragma once

#include <cstdint>
#include <cstring>

#include "geometry/io/output_file.h"

namespace af2::geometry {

/// Encodes a stream of values to base64, three bytes at a time.
class Base64Stream {
 public:
  explicit Base64Stream(OutputFile& file) : file_(file) {}

  template <class T>
  void put(T value) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof value);
    for (const unsigned char byte : bytes) {
      group_ = group_ << 8 | byte;
      if (++held_ == 3) encodeGroup();
    }
  }

  /// Must be called after the last value.
  void finish() {
    if (held_ == 0) return;
    const int missing = 3 - held_;
    group_ <<= 8 * missing;
    const char digits[4] = {kDigits[group_ >> 18 & 63], kDigits[group_ >> 12 & 63],
                            missing == 2 ? '=' : kDigits[group_ >> 6 & 63], '='};
    file_.bytes(digits, sizeof digits);
  }

 private:
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

  void encodeGroup() {
    const char digits[4] = {kDigits[group_ >> 18 & 63], kDigits[group_ >> 12 & 63],
                            kDigits[group_ >> 6 & 63], kDigits[group_ & 63]};
    file_.bytes(digits, sizeof digits);
    group_ = 0;
    held_ = 0;
  }

  OutputFile& file_;
  std::uint32_t group_ = 0;
  int held_ = 0;
};

}  // namespace af2::geometry
