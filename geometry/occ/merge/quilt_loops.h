// The loops around faces that are meshed together.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/occ/edges/merged_edges.h"
#include "geometry/occ/merge/background.h"

namespace af2::geometry {

/// An edge, or a chain of edges, in the direction of a loop, with the faces on its left.
struct QuiltUse {
  int edge = 0;  ///< of a chain: its id
  bool isReversed = false;
  std::vector<std::uint32_t> triangles;  ///< of the background, along this side of it
};

struct QuiltLoops {
  std::vector<std::vector<QuiltUse>> loops;
  double length = 0;  ///< of all loops
  int euler = 0;      ///< vertices - edges + triangles: 2 - loops if the faces can be laid out flat
};

/// The loops of followed edges around some triangles.
///
/// triangles  of the background
/// isInner    by edge, [0] is edge 1: it is not followed
///
/// Throws GeometryError if the triangles do not fit together, or the edges of a chain do not follow
/// each other.
QuiltLoops loopsAround(const BackgroundFacets& background,
                       const std::vector<std::uint32_t>& triangles,
                       const std::vector<bool>& isInner, const std::vector<EdgeChain>& chains);

}  // namespace af2::geometry
