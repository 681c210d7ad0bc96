// Edges in parts, between the vertices of other edges that they pass.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/edge_samples.h"
#include "geometry/occ/given_points.h"
#include "geometry/occ/open_ends.h"

namespace af2::geometry {

/// Of an edge between two of the points that it passes, or all of it.
struct EdgePart {
  std::size_t edge = 0;  ///< [0] is edge 1
  EdgeSamples samples;
  Ends ends;
  /// Whether it begins and ends where the edge does, not where that only passes another one's end.
  bool isFirst = true, isLast = true;

  EdgeRange range() const {
    return {samples.pieces.front().parameters.front(), samples.pieces.back().parameters.back(),
            samples.length, 0};
  }
};

/// The samples of the parts between these parameters, which lie in order between the ends.
std::vector<EdgeSamples> split(const EdgeSamples& samples, const std::vector<double>& parameters);

/// The parameter at a length from the start, which lies between the ends.
double parameterAt(const EdgeSamples& samples, double length);

}  // namespace af2::geometry
