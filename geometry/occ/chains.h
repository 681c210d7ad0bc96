// From directed chains of vertices, one for each edge, to closed loops.
#pragma once

#include <vector>

#include "engine/front_input.h"

namespace af2::geometry {

/// An edge as a face runs along it: at least two corners, the region on the left.
struct Chain {
  int edge = 0;
  bool reversed = false;  ///< against the direction of the edge
  std::vector<BoundaryCorner> corners;
};

/// Takes out pairs of edges of a single segment that join the same two vertices in opposite
/// directions: between them there is no room.
void cancelOppositeChains(std::vector<Chain>& chains);

/// Chains joined to loops.
struct LinkedLoops {
  std::vector<std::vector<BoundaryCorner>> loops;
  /// Whether each chain starts at the parameters (u, v) at which the one before ends, so that the
  /// loops are closed in the plane of the parameters. They are not at poles.
  bool closedInParameters = true;
};

/// Where several chains meet at a vertex, each is followed by the one that bounds the same sector,
/// in the tangent plane.
///
/// Throws GeometryError if some chain has no successor: the boundary is not closed.
LinkedLoops linkChains(std::vector<Chain> chains);

}  // namespace af2::geometry
