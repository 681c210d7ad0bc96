#include "geometry/meshing/even_division.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <vector>

#include "geometry/base/parallel.h"
#include "geometry/edges/even_loops.h"

namespace af2::geometry {

namespace {

/// Faces whose boundary is faulty have no loops; they fail when they are meshed.
std::vector<CountedLoop> allLoops(const FaceSource& source, const DividedEdges& divided,
                                  int threads, const std::stop_token& stop) {
  std::vector<std::vector<CountedLoop>> byFace(static_cast<std::size_t>(source.faceCount()));
  forEachInParallel(byFace.size(), threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    try {
      byFace[i] = source.loopsOf(static_cast<int>(i) + 1, divided);
    } catch (const std::exception&) {
    }
  });
  std::vector<CountedLoop> loops;
  for (std::vector<CountedLoop>& ofFace : byFace)
    std::ranges::move(ofFace, std::back_inserter(loops));
  return loops;
}

/// Marks counts that did not follow their change as fixed. Returns whether there are any.
bool fixDisobedient(const DividedEdges& divided, const SegmentChanges& changes,
                    std::vector<SegmentCount>& counts) {
  bool areAny = false;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto wanted = static_cast<std::ptrdiff_t>(counts[i].segments) + changes[i];
    if (changes[i] == 0 || static_cast<std::ptrdiff_t>(divided.counts[i].segments) == wanted)
      continue;
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
  const std::vector<CountedLoop> loops = allLoops(source, divided, threads, stop);
  std::vector<SegmentCount> counts = divided.counts;
  bool isDone = stop.stop_requested();
  for (int round = 0; round < kMaxRounds && !isDone; ++round) {
    const SegmentChanges changes = makeLoopsEven(counts, loops).changes;
    divided = source.divide(sizes, asPoints, changes);
    // Near tips, cusps and collapsed edges, rules for single segments may undo a change.
    isDone = !fixDisobedient(divided, changes, counts);
  }
  return divided;
}

}  // namespace af2::geometry
