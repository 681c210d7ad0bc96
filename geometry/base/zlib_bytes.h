// Bytes compressed by zlib, and back. Not installed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace af2::geometry {

std::string compressed(std::string_view bytes);

/// Nothing if the bytes are damaged, or do not stand for exactly `size` bytes.
std::optional<std::string> uncompressed(std::string_view bytes, std::uint64_t size);

}  // namespace af2::geometry
