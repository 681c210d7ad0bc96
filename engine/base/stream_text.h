// Reads streams as a whole. Not installed.
#pragma once

#include <istream>
#include <limits>
#include <string>

namespace af2 {

inline constexpr std::size_t kAllBytes = std::numeric_limits<std::size_t>::max();

/// What is left of a stream, but no more than `most` bytes. The memory grows with what there is to
/// read: most files are short, and the size of a stream need not be known.
///
/// expected  how many bytes there probably are, so that there is room for them at once; 0: unknown
std::string restOf(std::istream& in, std::size_t most = kAllBytes, std::size_t expected = 0);

}  // namespace af2
