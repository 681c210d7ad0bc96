// A way to fill a face: what is left of a stuck front is closed without rules.
// Not installed.
#pragma once

#include <cstddef>

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Closes the first of the fronts that are stuck and can be closed.
FaceAttempt fillByClosing(FillState& state);

/// Closes the front of one attempt, if the result is sound; else leaves it as it is.
///
/// maxEdges  of the front
bool closeStuck(const FaceTask& task, FaceAttempt& attempt, std::size_t maxEdges);

}  // namespace af2::geometry
