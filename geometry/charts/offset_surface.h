// Surfaces at a distance from others. Not installed.
#pragma once

#include <optional>

#include "geometry/charts/surface_frame.h"

namespace af2::geometry {

/// The place of an offset surface above a place of its base. Of the second derivatives, only the
/// parts along the normal are right, which tell how the surface bends; the others would need third
/// derivatives.
///
/// offset  along du x dv of the base
///
/// Nothing where the base has no normal.
std::optional<SurfaceJet> offsetBend(const SurfaceJet& base, double offset);

}  // namespace af2::geometry
