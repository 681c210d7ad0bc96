// A check before a face is filled: whether segments of its boundary cross.
// Not installed.
#pragma once

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Chords of a narrow plane face may cross between their ends. No front can fill such a boundary,
/// and a front takes long to find that out; so faces that have failed before are checked first.
bool mayHaveCrossedBoundary(const FillState& state);
/// Makes no mesh; the fault of the attempt says whether segments cross.
FaceAttempt findCrossedBoundary(FillState& state);

}  // namespace af2::geometry
