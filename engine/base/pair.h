// Two coordinates in one SIMD register. Each one is computed exactly as it would be alone, so that
// every processor gets the same results.
#pragma once

#include <bit>
#include <cstddef>

#include "engine/base/point.h"

namespace af2 {

using Pair = double __attribute__((vector_size(16)));

inline Pair smaller(Pair p, Pair q) { return q < p ? q : p; }
inline Pair larger(Pair p, Pair q) { return p < q ? q : p; }

/// 1 if a comparison holds for both coordinates, else 0.
inline std::ptrdiff_t bothHold(decltype(Pair{} < Pair{}) comparison) {
  return -(comparison[0] & comparison[1]);
}

static_assert(sizeof(Point2) == sizeof(Pair));
inline Point2 pointAt(Pair position) { return std::bit_cast<Point2>(position); }
inline Pair pairAt(Point2 point) { return std::bit_cast<Pair>(point); }

}  // namespace af2
