// A check before a face is filled: whether segments of its boundary cross.
// Not installed.
#pragma once

#include <string>

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Chords of a narrow plane face may cross between their ends. No front can fill such a boundary,
/// and a front takes long to find that out; so faces that have failed before are checked first.
bool mayHaveCrossedBoundary(const FillState& state);
/// Makes no mesh; the fault of the attempt says whether segments cross.
FaceAttempt findCrossedBoundary(FillState& state);

/// For the message of a plane face that failed: that segments of its boundary cross or lie on each
/// other, and where. Empty if none do.
std::string textOfCrossedBoundary(const ChartedSurface& surface, const FrontInput& boundary);

}  // namespace af2::geometry
