// The samples of all edges of a model, and their limits by sizes that change.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <stop_token>
#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"

namespace af2::geometry {

/// The samples of all edges, by edge. They are made once and serve all divisions of a model by
/// sizes that differ only in their function.
struct SampledEdges {
  std::vector<EdgeSamples> byFaces;  ///< sampleEdge; without pieces where `limited` is the same
  std::vector<EdgeSamples> limited;  ///< the same with the limits of `function`
  PositionSize function;

  /// Of an edge, with all its pieces.
  const EdgeSamples& withoutLimits(std::size_t edge) const {
    return byFaces[edge].pieces.empty() ? limited[edge] : byFaces[edge];
  }
};

SampledEdges sampleEdges(const ModelShape& model, const CadSizes& sizes, int threads,
                         const std::stop_token& stop);

/// The samples with the limits of sizes that are nowhere larger than those of `sampled`. Only the
/// edges that these limits reach are looked at again.
std::vector<EdgeSamples> limitedSamples(const ModelShape& model, const SampledEdges& sampled,
                                        const CadSizes& sizes, int threads,
                                        const std::stop_token& stop);

}  // namespace af2::geometry
