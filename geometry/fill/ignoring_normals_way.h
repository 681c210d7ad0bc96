// Ways to fill a curved face on which everything else has failed: elements may tilt against the
// surface by any angle.
// Not installed.
#pragma once

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

/// Whether the boundary is a closed curve in the parameters.
bool canIgnoreNormalsInParameters(const FillState& state);
/// Fills the face as long as no element folds over in the parameters.
FaceAttempt fillIgnoringNormals(FillState& state);

/// Whether a front may be closed loop by loop: on curved faces without isolated points that must be
/// vertices.
bool canCloseLoops(const FillState& state);
/// Closes the rest of a front loop by loop. A patch where fillets meet may be curved more than its
/// few elements can follow: the front then leaves small loops, where only the edges indicate the
/// orientation of the elements, or nothing fits at all.
FaceAttempt fillAcrossLoops(FillState& state);

}  // namespace af2::geometry
