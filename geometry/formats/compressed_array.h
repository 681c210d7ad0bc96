// An array of a VTU file whose values are compressed. Not installed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/base/zlib_bytes.h"
#include "geometry/io/base64.h"

namespace af2::geometry {

/// The layout of vtkZLibDataCompressor: the number of blocks, their size, the size of the last one
/// unless it is full, and their compressed sizes; then the blocks.
class CompressedArray {
 public:
  explicit CompressedArray(OutputFile& file) : file_(file) { block_.reserve(kBlock); }

  template <class T>
  void put(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof value);
    for (const char byte : bytes) {
      block_.push_back(byte);
      if (block_.size() == kBlock) endBlock();
    }
  }

  /// Must be called after the last value.
  void finish() {
    const std::uint64_t last = block_.size();
    if (last > 0) endBlock();
    Base64Stream head(file_);
    head.put(std::uint64_t{blocks_.size()});
    head.put(std::uint64_t{kBlock});
    head.put(last);
    for (const std::string& block : blocks_) head.put(std::uint64_t{block.size()});
    head.finish();
    Base64Stream data(file_);
    for (const std::string& block : blocks_)
      for (const char byte : block) data.put(byte);
    data.finish();
  }

 private:
  static constexpr std::size_t kBlock = 1 << 18;

  void endBlock() {
    blocks_.push_back(compressed(block_));
    block_.clear();
  }

  OutputFile& file_;
  std::string block_;
  std::vector<std::string> blocks_;
};

}  // namespace af2::geometry
