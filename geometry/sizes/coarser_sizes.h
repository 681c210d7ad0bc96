// The same sizes, but larger.
#pragma once

#include "geometry/sizes/sizes.h"

namespace af2::geometry {

/// All sizes `factor` times as large, with their bounds; a turn and a narrow place get as many
/// times fewer elements, and bounds on the distance from the model, which goes with the square of
/// the size, become larger by the square.
Sizes timesAsLarge(Sizes sizes, double factor);

}  // namespace af2::geometry
