#include "engine/optimize.h"

#include "engine/edge_collapse.h"
#include "engine/edge_swap.h"
#include "engine/mesh_topology.h"
#include "engine/smoothing.h"

namespace af2 {

OptimizeReport optimizeMesh(Mesh& mesh, const FrontInput& input,
                            const AF2LocalTransformMaker& maker, const SizeField& size,
                            const OptimizeOptions& options) {
  OptimizeReport report;
  MeshTopology topology(mesh, input);
  const std::vector<std::uint8_t> wanted = wantedValences(topology);
  const auto smooth = [&] {
    for (int sweep = 0; sweep < options.smoothingSweeps; ++sweep) {
      if (options.stop.stop_requested()) return;
      report.moves += smoothVertices(topology, mesh, maker, size);
    }
  };
  for (int round = 0; round < options.rounds; ++round) {
    if (options.stop.stop_requested()) break;
    report.swaps += swapSides(topology, SwapGoal::Valence, wanted);
    report.collapses += collapseEdges(topology);
    smooth();
    report.swaps += swapSides(topology, SwapGoal::Shape, wanted);
  }
  smooth();
  topology.compact();
  return report;
}

}  // namespace af2
