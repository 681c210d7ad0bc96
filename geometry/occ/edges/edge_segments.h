// The number of segments of an edge, and their ends, from samples of it.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/occ/edges/edge_samples.h"

namespace af2::geometry {

/// What is asked of the number of segments besides the sizes.
struct AskedSegments {
  std::size_t least = 1;
  int change = 0;  ///< from the number by sizes: -1 or more
};

/// Parameters that divide the edge into segments of the wanted sizes, ends included. The number of
/// segments is rounded to the nearest; with sizes.elementsPerTurn, no segment that turns is longer
/// than wanted. The number changes to one fewer only where the least number allows it, and where no
/// segment that turns becomes longer than wanted.
std::vector<double> divide(const EdgeSamples& samples, AskedSegments asked, const CadSizes& sizes);

/// The number of segments if all had exactly the wanted sizes.
double wantedSegments(const EdgeSamples& samples);

/// The number of segments below which `divide` makes no change.
std::size_t fewestSegmentsOf(const EdgeSamples& samples, const CadSizes& sizes);

}  // namespace af2::geometry
