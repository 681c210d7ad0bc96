// Reverses wires of a plane face that have the wrong direction.
#pragma once

#include <functional>
#include <vector>

#include "geometry/occ/faces/chains.h"

namespace af2::geometry {

/// Reverses the wires that have the face on their right: in a plane, their nesting determines this.
/// Returns how many were reversed.
///
/// wire     by chain, the wire that it belongs to: 0, 1, ...
/// inPlane  maps corners to the plane, as seen from the side to which the normals point
int orientWires(std::vector<Chain>& chains, const std::vector<std::size_t>& wire,
                const std::function<Point2(const SurfacePoint&)>& inPlane);

}  // namespace af2::geometry
