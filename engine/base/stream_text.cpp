#include "engine/base/stream_text.h"

#include <algorithm>

namespace af2 {

std::string restOf(std::istream& in, std::size_t most) {
  constexpr std::size_t kFirst = 1 << 14, kLargest = 1 << 24;
  std::string text;
  for (std::size_t piece = kFirst; in && text.size() < most;
       piece = std::min(2 * piece, kLargest)) {
    const std::size_t before = text.size();
    text.resize(before + std::min(piece, most - before));
    in.read(text.data() + before, static_cast<std::streamsize>(text.size() - before));
    text.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  return text;
}

}  // namespace af2
