// Reads streams as a whole. Not installed.
#pragma once

#include <istream>
#include <limits>
#include <string>

namespace af2 {

/// What is left of a stream, but no more than `most` bytes. The memory grows with what there is to
/// read: most files are short, and the size of a stream need not be known.
std::string restOf(std::istream& in, std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace af2
