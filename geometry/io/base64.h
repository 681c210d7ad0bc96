// Writes binary values as base64. Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "geometry/io/output_file.h"

namespace af2::geometry {

/// Encodes a stream of values to base64, many at a time.
class Base64Stream {
 public:
  explicit Base64Stream(OutputFile& file) : file_(file) {}

  template <class T>
  void put(T value) {
    if (kBlock - used_ < sizeof value) encodeGroups();
    std::memcpy(bytes_.data() + used_, &value, sizeof value);
    used_ += sizeof value;
  }
  void bytes(std::string_view many) {
    for (const char byte : many) put(byte);
  }

  /// Must be called after the last value.
  void finish();

 private:
  static constexpr std::size_t kGroup = 3, kBlock = kGroup << 12;

  void encodeGroups();

  OutputFile& file_;
  std::array<unsigned char, kBlock> bytes_;  ///< not encoded yet
  std::size_t used_ = 0;
};

}  // namespace af2::geometry
