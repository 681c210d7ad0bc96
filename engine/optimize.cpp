#include "engine/optimize.h"

#include <algorithm>

#include "engine/edge_collapse.h"
#include "engine/edge_swap.h"
#include "engine/mesh_check.h"
#include "engine/mesh_topology.h"
#include "engine/quad_tidying.h"
#include "engine/smoothing.h"

namespace af2 {

OptimizeReport optimizeMesh(Mesh& mesh, const MeshBoundary& boundary,
                            const AF2LocalTransformMaker& maker, const OptimizeOptions& options) {
  OptimizeReport report;
  Mesh before = mesh;
  MeshTopology topology(mesh, boundary);
  VertexSmoother smoother(topology, mesh, maker);
  const std::vector<double> angles = topology.anglesAtFixed();
  const std::vector<std::uint8_t> wanted = wantedValences(angles);
  const bool hasQuads = std::ranges::any_of(mesh.elements, &Element::isQuad);
  const int rounds = options.rounds + (hasQuads ? 1 : 0);
  const auto smooth = [&] {
    for (int sweep = 0; sweep < options.smoothingSweeps; ++sweep)
      if (!options.stop.stop_requested()) report.moves += smoother.sweep(options.stop);
  };
  for (int round = 0; round < rounds && !options.stop.stop_requested(); ++round) {
    if (hasQuads) {
      smooth();
      report.replacements += tidyQuads(topology, angles);
      smoother.wakeAll();
    }
    report.swaps += swapSides(topology, SwapGoal::Valence, wanted);
    if (options.collapse) report.collapses += collapseEdges(topology);
    smooth();
    report.swaps += swapSides(topology, SwapGoal::Shape, wanted);
    smoother.wakeAll();
  }
  smooth();
  topology.compact();
  if (checkMesh(mesh, boundary).empty()) return report;
  mesh = std::move(before);
  return {};
}

}  // namespace af2
