// Looked for before a face is filled: segments of its boundary that cross.
// Not installed.
#pragma once

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Chords of a narrow plane face may cross between their ends. No front could fill what they bound,
/// and to find that out takes long: so it is looked for first on a face that has failed before.
bool mayHaveCrossedBoundary(const FillState& state);
/// Makes no mesh: its fault says whether segments cross.
FaceAttempt findCrossedBoundary(FillState& state);

}  // namespace af2::geometry
