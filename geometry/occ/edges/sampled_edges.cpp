#include "geometry/occ/edges/sampled_edges.h"

#include <algorithm>

#include "engine/base/parallel.h"

namespace af2::geometry {

namespace {

bool isSame(const EdgePiece& a, const EdgePiece& b) {
  return a.parameters == b.parameters && a.sizes == b.sizes;
}

}  // namespace

SampledEdges sampleEdges(const ModelShape& model, const CadSizes& sizes, int threads,
                         const std::stop_token& stop) {
  const auto count = static_cast<std::size_t>(model.edges.Extent());
  SampledEdges sampled{std::vector<EdgeSamples>(count), std::vector<EdgeSamples>(count),
                       sizes.function};
  forEachInParallel(count, threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const int edge = static_cast<int>(i) + 1;
    EdgeSamples &byFaces = sampled.byFaces[i], &limited = sampled.limited[i];
    byFaces = sampleEdge(model, edge, sizes);
    limited = limitedByPosition(model, edge, sizes, byFaces);
    if (std::ranges::equal(byFaces.pieces, limited.pieces, isSame)) byFaces.pieces = {};
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
    limited[i] =
        isSame || isWithinLimits(less, sizes, known, areDense)
            ? known
            : limitedByPosition(model, static_cast<int>(i) + 1, sizes, sampled.withoutLimits(i));
  });
  return limited;
}

}  // namespace af2::geometry
