// Wires of a plane face that run the wrong way round.
#pragma once

#include <functional>
#include <vector>

#include "geometry/occ/faces/chains.h"

namespace af2::geometry {

/// Turns round the wires that have the face on their right: in a plane it can be told from how they
/// lie in each other. Returns how many were turned.
///
/// wire     by chain, the wire that it belongs to: 0, 1, ...
/// inPlane  draws corners in the plane, seen from the side to which the normals point
int orientWires(std::vector<Chain>& chains, const std::vector<std::size_t>& wire,
                const std::function<Point2(const SurfacePoint&)>& inPlane);

}  // namespace af2::geometry
