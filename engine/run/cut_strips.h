// Optimises the strips of elements along the cuts of a region after its pieces are joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"
#include "engine/optimize/optimize.h"
#include "engine/run/region_split.h"

namespace af2 {

/// In order, the elements with a vertex fewer than four rings away from a cut. The cuts run along
/// the vertices of the piece that are not vertices of the region; the region's vertices have ids
/// below `given`.
std::vector<std::uint32_t> elementsAlongCuts(const Mesh& mesh, const RegionPiece& piece,
                                             std::size_t given);

/// The elements along cuts in a joined mesh.
struct AlongCuts {
  std::vector<std::size_t> elements;  ///< in the order of the pieces
  std::vector<std::size_t> start;     ///< by piece: its first entry in `elements`; then the end
};

/// What the optimisation of the strips needs.
struct StripTools {
  /// Finishes one strip, in place. It may add and remove elements and inner vertices. Must be
  /// callable from several threads at once.
  std::function<void(Mesh&, const MeshBoundary&, const OptimizeOptions&)> finish;
  /// Calls its argument for 0 to count - 1, in any order, and returns when all calls are done.
  std::function<void(std::size_t count, const std::function<void(std::size_t)>&)> forEach;
  std::stop_token stop;
};

/// Optimises the joined mesh of a region along its cuts, where cut vertices can move. The cuts made
/// last come first, each within the part of the region that it divided; cuts of the same depth are
/// optimised in parallel.
void optimizeAlongCuts(Mesh& mesh, const FrontInput& input, const SplitRegion& split,
                       const AlongCuts& along, const StripTools& tools);

}  // namespace af2
