#include "geometry/base/zlib_bytes.h"

#include <zlib.h>

#include <new>

namespace af2::geometry {

std::string compressed(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  // It fails only without memory: the room is enough for anything.
  if (compress(reinterpret_cast<Bytef*>(result.data()), &size,
               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != Z_OK)
    throw std::bad_alloc();
  result.resize(size);
  return result;
}

std::optional<std::string> uncompressed(std::string_view bytes, std::uint64_t size) {
  constexpr std::uint64_t kMostPerByte = 1100;  // zlib reaches 1032
  if (size > kMostPerByte * (bytes.size() + 1)) return std::nullopt;
  std::string result(size, '\0');
  uLongf length = size;
  if (uncompress(reinterpret_cast<Bytef*>(result.data()), &length,
                 reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != Z_OK ||
      length != size)
    return std::nullopt;
  return result;
}

}  // namespace af2::geometry
