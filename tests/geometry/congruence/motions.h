// Motions for tests of congruent faces.
#pragma once

#include "geometry/congruence/motion.h"

namespace af2::testing {

const geometry::Frame kOrigin = geometry::Frame::at({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
const geometry::Motion kStill(kOrigin, kOrigin);
/// Turned about a slanted axis, and moved away.
const geometry::Motion kAway(kOrigin, geometry::Frame::at({7, -2, 5}, {8, 1, 6}, {5, 3, 3}));
/// In a mirror that stands on the plane z = 0.
const geometry::Motion kMirror(kOrigin,
                               geometry::Frame::at({9, 0, 0}, {8, 0, 0}, {9, 1, 0}).reflected());

}  // namespace af2::testing
