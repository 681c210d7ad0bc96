// Edges, or parts of them, that run along the same curve: the two sides of a seam that was not made
// one, or of a face where it has no width, or edges of faces that were not sewn.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>
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
            samples.length};
  }
};

/// For each part an earlier one between the same points that it runs along: some face has both, and
/// they are as near as their tolerances say; or each bounds one face only, from one side and the
/// other, and they are within a thousandth of the wanted size. Parts are in the order of their
/// edges.
std::vector<std::optional<std::size_t>> twinsOf(const ModelShape& model,
                                                const std::vector<EdgePart>& parts);

}  // namespace af2::geometry
