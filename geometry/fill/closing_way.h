// A way to fill a face: close the rest of a stuck front without rules.
// Not installed.
#pragma once

#include <cstddef>

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Closes the first stuck front that can be closed.
FaceAttempt fillByClosing(FillState& state);

/// Closes the front of one attempt, if the result is sound; otherwise leaves the attempt unchanged.
///
/// maxEdges  of the front
bool closeStuck(const FaceTask& task, FaceAttempt& attempt, std::size_t maxEdges);

}  // namespace af2::geometry
