#include "geometry/meshing/even_division.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <vector>

#include "engine/base/parallel.h"
#include "geometry/edges/even_loops.h"
#include "geometry/edges/facing_counts.h"

namespace af2::geometry {

namespace {

struct Boundaries {
  std::vector<CountedLoop> loops;
  std::vector<FacingPair> facing;
};

/// Those that a face has once. A seam has the same vertices on both sides anyway.
std::vector<std::size_t> onceIn(const std::vector<CountedLoop>& loops) {
  std::vector<std::size_t> all, once;
  for (const CountedLoop& loop : loops)
    all.insert(all.end(), loop.counts.begin(), loop.counts.end());
  std::ranges::sort(all);
  for (std::size_t i = 0; i < all.size(); ++i)
    if ((i == 0 || all[i - 1] != all[i]) && (i + 1 == all.size() || all[i + 1] != all[i]))
      once.push_back(all[i]);
  return once;
}

/// Faces whose boundary is faulty have no loops; they fail when they are meshed.
Boundaries allBoundaries(const FaceSource& source, const DividedEdges& divided, int threads,
                         const std::stop_token& stop) {
  const FacingEdges facing(divided);
  std::vector<Boundaries> byFace(static_cast<std::size_t>(source.faceCount()));
  forEachInParallel(byFace.size(), threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    try {
      byFace[i].loops = source.loopsOf(static_cast<int>(i) + 1, divided);
      byFace[i].facing = facing.around(onceIn(byFace[i].loops));
    } catch (const std::exception&) {
    }
  });
  Boundaries all;
  for (Boundaries& ofFace : byFace) {
    std::ranges::move(ofFace.loops, std::back_inserter(all.loops));
    std::ranges::move(ofFace.facing, std::back_inserter(all.facing));
  }
  return all;
}

/// From the numbers by sizes alone to those of `counts`, and on by `changes`.
SegmentChanges sumOf(const std::vector<SegmentCount>& bySizes,
                     const std::vector<SegmentCount>& counts, SegmentChanges changes) {
  for (std::size_t i = 0; i < counts.size(); ++i)
    changes[i] += static_cast<int>(counts[i].segments) - static_cast<int>(bySizes[i].segments);
  return changes;
}

/// Counts that did not follow their change go back to the number by sizes, and are fixed. Returns
/// whether there are any.
bool fixDisobedient(const DividedEdges& divided, const SegmentChanges& changes,
                    const std::vector<SegmentCount>& bySizes, std::vector<SegmentCount>& counts) {
  bool areAny = false;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto wanted = static_cast<std::ptrdiff_t>(bySizes[i].segments) + changes[i];
    if (changes[i] == 0 || static_cast<std::ptrdiff_t>(divided.counts[i].segments) == wanted)
      continue;
    counts[i] = bySizes[i];
    counts[i].isFixed = true;
    areAny = true;
  }
  return areAny;
}

}  // namespace

DividedEdges divideWithEvenLoops(const FaceSource& source, const PositionSize& sizes,
                                 const CollapsedEdges& asPoints, int threads,
                                 const std::stop_token& stop) {
  constexpr int kMaxRounds = 5;  // a second one is rare
  DividedEdges divided = source.divide(sizes, asPoints, {});
  const Boundaries boundaries = allBoundaries(source, divided, threads, stop);
  const std::vector<SegmentCount> bySizes = divided.counts;
  std::vector<SegmentCount> counts = bySizes;
  const std::vector<FacingCounts> facing = matchFacing(boundaries.facing, counts);
  bool isDone = stop.stop_requested();
  for (int round = 0; round < kMaxRounds && !isDone; ++round) {
    const SegmentChanges changes =
        sumOf(bySizes, counts, makeLoopsEven(counts, boundaries.loops, facing).changes);
    divided = source.divide(sizes, asPoints, changes);
    // Near tips, cusps and collapsed edges, rules for single segments may undo a change.
    isDone = !fixDisobedient(divided, changes, bySizes, counts);
  }
  return divided;
}

}  // namespace af2::geometry
