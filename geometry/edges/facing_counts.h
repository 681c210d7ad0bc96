// Numbers of segments of edges that face each other across a strip one element wide.
// Not installed.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/edges/even_loops.h"

namespace af2::geometry {

/// Two indices in DividedEdges::counts, the lower one first.
using FacingPair = std::pair<std::size_t, std::size_t>;

class FacingEdges {
 public:
  explicit FacingEdges(const DividedEdges& divided);

  /// The pairs of edges around a face that face each other along their whole lengths, at a distance
  /// of at most one and a half segments.
  ///
  /// ofFace  indices in DividedEdges::counts: those around the face, ascending, each once
  std::vector<FacingPair> around(const std::vector<std::size_t>& ofFace) const;

 private:
  /// A part of an edge: its points from `first` to `last`.
  struct Part {
    std::size_t edge = 0, first = 0, last = 0;
  };
  const DividedEdges& divided_;
  std::vector<Part> parts_;  ///< by count; of several with the same vertices, the last one
};

/// Gives edges that face each other equal numbers of segments: the larger one, where the other edge
/// gets at most a quarter more segments for this. Given divisions do not change.
///
/// Returns the sets of edges that should change together from here on.
std::vector<FacingCounts> matchFacing(const std::vector<FacingPair>& pairs,
                                      std::vector<SegmentCount>& counts);

}  // namespace af2::geometry
