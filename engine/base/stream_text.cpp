#include "engine/base/stream_text.h"

#include <algorithm>

namespace af2 {

std::string restOf(std::istream& in, std::size_t most, std::size_t expected) {
  constexpr std::size_t kFirst = 1 << 14, kLargest = 1 << 24;
  std::string text;
  if (expected > 0) text.reserve(expected + 1);  // the end is found where one more is missing
  for (std::size_t piece = kFirst; in && text.size() < most;
       piece = std::min(2 * piece, kLargest)) {
    const std::size_t before = text.size();
    text.resize(before + std::min(std::max(piece, text.capacity() - before), most - before));
    in.read(text.data() + before, static_cast<std::streamsize>(text.size() - before));
    text.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  return text;
}

}  // namespace af2
