// Links directed chains of vertices, one for each edge, to closed loops.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "engine/mesh/front_input.h"

namespace af2::geometry {

/// An edge, or a part of it, in the direction in which a face uses it: at least two corners, with
/// the region on the left.
struct Chain {
  int edge = 0;
  bool reversed = false;           ///< against the direction of the edge
  std::uint32_t firstSegment = 0;  ///< of the edge
  std::vector<BoundaryCorner> corners;
};

/// Removes pairs of edges of a single segment that join the same two vertices in opposite
/// directions, because there is no room between them.
void cancelOppositeChains(std::vector<Chain>& chains);

/// Removes pairs of chains of different edges for which `runBack` holds, such as chains with the
/// same vertices in opposite directions: where they touch, there is no room between them. Chains of
/// the same wire with the region on both sides are a slit, which is kept.
///
/// wire     to which each chain belongs
/// inPlane  the map to the plane of the boundary
///
/// Returns the pairs.
std::vector<std::pair<Chain, Chain>> cancelTouching(
    std::vector<Chain>& chains, const std::vector<std::size_t>& wire,
    const std::function<bool(const Chain&, const Chain&)>& runBack,
    const std::function<Point2(const SurfacePoint&)>& inPlane);

/// Whether two chains have the same vertices in opposite directions.
bool areOpposite(const Chain& one, const Chain& other);

/// Gives the vertices, whose ids are numbers of points, ids from 0 on in the order of the chains.
/// Returns the point of each.
std::vector<std::uint32_t> numberVertices(std::vector<Chain>& chains);

/// Chains joined to loops.
struct LinkedLoops {
  std::vector<std::vector<BoundaryCorner>> loops;
  /// A place, such as a pole, where a chain starts at other parameters (u, v) than those at which
  /// the previous chain ends, so that the loops are not closed in the plane of the parameters.
  struct Jump {
    SurfacePoint end, start;
  };
  std::vector<Jump> jumps;

  bool closedInParameters() const { return jumps.empty(); }
};

/// Where several chains meet at a vertex, each is followed by the one that bounds the same sector,
/// in the tangent plane.
///
/// Throws GeometryError if some chain has no successor: the boundary is not closed.
LinkedLoops linkChains(std::vector<Chain> chains);

}  // namespace af2::geometry
