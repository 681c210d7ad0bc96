// Scores a state of all faces, and the faults of one face.
// Not installed.
#pragma once

#include <compare>
#include <cstddef>

#include "geometry/retry/retries.h"

namespace af2::geometry {

/// Compared in this order; less is better.
struct Score {
  std::size_t failedFaces = 0;  ///< including those that must be removed so that no elements cross
  std::size_t badAngles = 0;    ///< faces with an element that is hardly usable
  double poorness = 0;          ///< of all faces that have not failed
  std::size_t elements = 0;     ///< fewer are better if all else is equal
  auto operator<=>(const Score&) const = default;
};

Score scoreOf(const FaceMeshes& state);

/// The number of pairs of crossing elements of which at least one belongs to the face.
std::ptrdiff_t crossingsAt(const FaceMeshes& state, std::size_t face);

}  // namespace af2::geometry
