// What a try at a face may do, and what it may cost.
// Not installed.
#pragma once

#include <cstddef>
#include <limits>

namespace af2::geometry {

/// As given: the first try at a face, which may take what it needs.
struct TryLimits {
  /// A front that has examined more candidates than these is given up.
  std::size_t maxCandidates = std::numeric_limits<std::size_t>::max();
  /// Elements may lean against the surface as far as they like: all else has failed.
  bool ignoresNormals = false;
  /// All tries at the face before have failed.
  bool failedBefore = false;
  /// The sizes are those that were asked for, without what remedies ask for.
  bool hasOriginalSizes = true;
};

}  // namespace af2::geometry
