// How good a state of all faces is, and what is wrong with one of them.
// Not installed.
#pragma once

#include <compare>
#include <cstddef>

#include "geometry/retry/retries.h"

namespace af2::geometry {

/// Compared one after the other; less is better.
struct Score {
  std::size_t failedFaces = 0;  ///< with those that must go so that no elements cross
  std::size_t badAngles = 0;    ///< faces with an element that is hardly of use
  double poorness = 0;          ///< of all faces that have not failed
  std::size_t elements = 0;     ///< the fewest, if all else is equal
  auto operator<=>(const Score&) const = default;
};

Score scoreOf(const FaceMeshes& state);

/// How many pairs of elements cross of which at least one belongs to a face.
std::ptrdiff_t crossingsAt(const FaceMeshes& state, std::size_t face);

}  // namespace af2::geometry
