// The strips of elements along the cuts of a region, optimised once its pieces are joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"
#include "engine/run/region_split.h"
#include "engine/surface/local_transform.h"

namespace af2 {

/// By element, in order: those with a vertex that is fewer than four rings away from a cut. The
/// cuts run along the vertices of the piece that are none of the region's, whose ids lie below
/// `given`.
std::vector<std::uint32_t> elementsAlongCuts(const Mesh& mesh, const RegionPiece& piece,
                                             std::size_t given);

/// Such elements of a joined mesh.
struct AlongCuts {
  std::vector<std::size_t> elements;  ///< in the order of the pieces
  std::vector<std::size_t> start;     ///< by piece: its first of `elements`; and their end
};

/// What the strips are optimised with.
struct StripTools {
  /// Must be callable from several threads at once.
  std::function<std::shared_ptr<const AF2LocalTransformMaker>()> makeCharts;
  /// Calls what it is given for 0 to count - 1, in any order, and returns once all is done.
  std::function<void(std::size_t count, const std::function<void(std::size_t)>&)> forEach;
  std::stop_token stop;
};

/// Optimises the joined mesh of a region along its cuts, with the cuts free to move. First along
/// those that were made last, each within the part of the region that it divided: cuts of the same
/// depth at the same time.
void optimizeAlongCuts(Mesh& mesh, const FrontInput& input, const SplitRegion& split,
                       const AlongCuts& along, const StripTools& tools);

}  // namespace af2
