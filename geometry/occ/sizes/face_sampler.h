// Sizes that a face wants inside, sampled on it. Not installed.
#pragma once

#include <vector>

#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"

namespace af2::geometry {

/// How fast sizes may grow away from what faces want inside.
double growthInside(const CadSizes& sizes);

/// Whether sizes inside all faces are to be known outside them: where they were asked for.
bool spreadsAll(const CadSizes& sizes);

struct SampledFace {
  std::vector<SizeSource> sources;
  /// Whether sizes changed faster than could be sampled, and not at some spot alone, such as a
  /// corner where the surface turns over. There are no sources then.
  bool isTooRough = false;
};

/// areAll  false: only the sources that others do not cover
SampledFace sampledFace(const ModelShape& model, int face, const CadSizes& sizes, bool areAll);

}  // namespace af2::geometry
