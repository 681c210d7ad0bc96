// An array of a VTU file whose values are compressed. Not installed.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "engine/base/parallel.h"
#include "geometry/base/zlib_bytes.h"
#include "geometry/io/base64.h"

namespace af2::geometry {

/// The layout of vtkZLibDataCompressor: the number of blocks, their size, the size of the last one
/// unless it is full, and their compressed sizes; then the blocks. Blocks are compressed on the
/// threads of the caller's TBB arena.
class CompressedArray {
 public:
  explicit CompressedArray(OutputFile& file) : file_(file) {}

  template <class T>
  void put(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof value);
    waiting_.append(bytes, sizeof value);
    if (waiting_.size() >= kBlock * kBlocksAtOnce) compressBlocks(kBlocksAtOnce);
  }

  /// Must be called after the last value.
  void finish() {
    const std::uint64_t last = waiting_.size() % kBlock;
    compressBlocks(Ranges(waiting_.size(), kBlock).count());
    Base64Stream head(file_);
    head.put(std::uint64_t{blocks_.size()});
    head.put(std::uint64_t{kBlock});
    head.put(last);
    for (const std::string& block : blocks_) head.put(std::uint64_t{block.size()});
    head.finish();
    Base64Stream data(file_);
    for (const std::string& block : blocks_) data.bytes(block);
    data.finish();
  }

 private:
  static constexpr std::size_t kBlock = 1 << 18, kBlocksAtOnce = 32;

  void compressBlocks(std::size_t count) {
    const std::size_t before = blocks_.size();
    blocks_.resize(before + count);
    forEachInParallel(count, 0, [&](std::size_t i) {
      blocks_[before + i] = compressed(std::string_view(waiting_).substr(kBlock * i, kBlock));
    });
    waiting_.erase(0, kBlock * count);
  }

  OutputFile& file_;
  std::string waiting_;  ///< to be compressed
  std::vector<std::string> blocks_;
};

}  // namespace af2::geometry
