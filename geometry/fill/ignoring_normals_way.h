// Ways to fill a curved face at which all else has failed: elements may lean against the surface as
// far as they like.
// Not installed.
#pragma once

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Whether the boundary is a closed curve in the parameters.
bool canIgnoreNormalsInParameters(const FillState& state);
/// As long as nothing folds over in the parameters.
FaceAttempt fillIgnoringNormals(FillState& state);

/// Whether a front may be closed across its loops: on curved faces without points that are to be
/// vertices.
bool canCloseLoops(const FillState& state);
/// A patch where fillets meet may be bent more than its few elements can follow: there the front
/// leaves little, across which only its edges tell how elements should lie; or nothing fits at all.
FaceAttempt fillAcrossLoops(FillState& state);

}  // namespace af2::geometry
