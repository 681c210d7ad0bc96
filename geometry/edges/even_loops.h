// Changes numbers of segments by one so that loops of edges get even numbers of segments.
// Not installed.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/edges/segment_count.h"

namespace af2::geometry {

/// A closed boundary of a face.
struct CountedLoop {
  /// Indices of counts, in any order, each as often as the loop runs along the edge.
  std::vector<std::size_t> counts;
  /// Whether its segments that belong to none of the counts are odd in number.
  bool hasOddRest = false;
};

/// Indices of counts of edges that face each other across a strip, ascending.
using FacingCounts = std::vector<std::size_t>;

struct EvenLoops {
  SegmentChanges changes;
  std::vector<std::size_t> odd;  ///< loops that cannot be made even, ascending
};

/// Makes as many loops even as possible, by changes that distort segments little.
///
/// A change of n segments to m costs n log(m / wanted)^2: the number of segments that become longer
/// or shorter, times the square of how much. Long edges change first, because one segment more or
/// less hardly shows there. The total is not always the least possible (joinOddNodes). Edges that
/// three or more loops use are changed only where loops cannot be made even without them.
///
/// facing  disjoint sets; the counts of each change together if possible
EvenLoops makeLoopsEven(const std::vector<SegmentCount>& counts,
                        const std::vector<CountedLoop>& loops,
                        const std::vector<FacingCounts>& facing = {});

}  // namespace af2::geometry
