// The permissions and the cost limit of a try at a face.
// Not installed.
#pragma once

#include <cstddef>
#include <limits>

namespace af2::geometry {

/// The defaults are those of the first try at a face, whose cost is not limited.
struct TryLimits {
  /// A front that has examined more candidates than this is stopped.
  std::size_t maxCandidates = std::numeric_limits<std::size_t>::max();
  /// Elements may tilt against the surface by any angle, because everything else has failed.
  bool ignoresNormals = false;
  /// Rule sets that accept quadrilaterals with a reflex corner do not get them: those of earlier
  /// tries could not be turned round.
  bool refusesReflex = false;
  /// All earlier tries at the face have failed.
  bool failedBefore = false;
  /// The sizes are those of the user, without the requests of remedies.
  bool hasOriginalSizes = true;

  /// Whether a try with other limits and the same sizes that has examined so many candidates would
  /// have come to the same end within these.
  bool allow(const TryLimits& other, std::size_t candidates) const {
    return candidates <= maxCandidates && ignoresNormals == other.ignoresNormals &&
           refusesReflex == other.refusesReflex && failedBefore == other.failedBefore;
  }
};

/// One try at a face.
struct FaceTry {
  std::size_t face = 0;  ///< in the order of the request, from 0
  TryLimits limits;
};

}  // namespace af2::geometry
