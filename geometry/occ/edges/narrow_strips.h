// Limits sizes along edges next to which a face is narrow.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/knotted_edges.h"
#include "geometry/occ/edges/open_ends.h"

namespace af2::geometry {

/// A limit for some samples of an edge: those from `first` to the one before `last`.
struct StripLimit {
  std::uint32_t edge;
  std::size_t piece, first, last;
  double size;
};

/// What was found in one division of the edges. Another one looks only at faces at edges with other
/// knots or ends. Empty: nothing is known yet.
struct KnownStrips {
  std::vector<KnottedEdge> edges;  ///< before the limits
  std::vector<Ends> ends;          ///< by edge
  std::vector<std::vector<StripLimit>> byFace;
};

/// Lowers the sizes along edges next to which the face is narrower than a certain share of the
/// size, so that elements across the strip have good angles, and the segments of its two sides have
/// equal lengths and face each other. Wedges are not changed, because no division opens their
/// angle.
///
/// ends     by edge; [0] is edge 1
/// samples  by edge
/// without  ids of faces that change nothing
/// known    of a division by sizes that differ only in their function; filled if it is empty. May
///          be null
void limitInStrips(const ModelShape& model, const CadSizes& sizes, const std::vector<Ends>& ends,
                   int threads, std::vector<EdgeSamples>& samples,
                   const std::set<int>& without = {}, KnownStrips* known = nullptr);

}  // namespace af2::geometry
