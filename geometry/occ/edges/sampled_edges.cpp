#include "geometry/occ/edges/sampled_edges.h"

#include "engine/base/parallel.h"

namespace af2::geometry {

SampledEdges sampleEdges(const ModelShape& model, const CadSizes& sizes, int threads,
                         const std::stop_token& stop) {
  const auto count = static_cast<std::size_t>(model.edges.Extent());
  SampledEdges sampled{std::vector<EdgeSamples>(count), std::vector<EdgeSamples>(count),
                       sizes.function};
  forEachInParallel(count, threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const int edge = static_cast<int>(i) + 1;
    sampled.byFaces[i] = sampleEdge(model, edge, sizes);
    sampled.limited[i] = limitedByPosition(model, edge, sizes, sampled.byFaces[i]);
  });
  return sampled;
}

std::vector<EdgeSamples> limitedSamples(const ModelShape& model, const SampledEdges& sampled,
                                        const CadSizes& sizes, int threads,
                                        const std::stop_token& stop) {
  const bool isSame = sizes.function.isSameAs(sampled.function);
  const bool areDense = sampled.function || sizes.elementsPerTurn > 0;
  const PositionSize& less = sizes.function.below(sampled.function);
  std::vector<EdgeSamples> limited(sampled.byFaces.size());
  forEachInParallel(limited.size(), threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const EdgeSamples& known = sampled.limited[i];
    limited[i] = isSame || isWithinLimits(less, sizes, known, areDense)
                     ? known
                     : limitedByPosition(model, static_cast<int>(i) + 1, sizes, sampled.byFaces[i]);
  });
  return limited;
}

}  // namespace af2::geometry
