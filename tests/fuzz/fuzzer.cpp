// One program for each reader; AF2_TRIED says which.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  af2::fuzz::AF2_TRIED(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
