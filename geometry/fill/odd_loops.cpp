#include "geometry/fill/odd_loops.h"

#include <algorithm>

namespace af2::geometry {
namespace {

using Loop = std::vector<BoundaryCorner>;

/// A segment that the face has on both sides counts twice, so that dividing it changes nothing.
FaceReport::OddLoop withLongestSegment(FaceReport::OddLoop odd, const Loop& loop,
                                       const MeshBoundary& boundary, const SizeField& wanted) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const BoundaryCorner &from = loop[i], &to = loop[(i + 1) % loop.size()];
    if (boundary.contains(to.vertex, from.vertex)) continue;
    const double size = 0.5 * (wanted.sizeAt(from.point) + wanted.sizeAt(to.point));
    const double sizes = distance(from.point.position, to.point.position) / size;
    if (!(sizes > odd.longest.sizes)) continue;
    odd.longest = {from.point.position, to.point.position, sizes};
  }
  return odd;
}

}  // namespace

std::vector<FaceReport::OddLoop> oddLoopsOf(const FrontInput& input, const SizeField* wanted) {
  std::vector<FaceReport::OddLoop> all;
  MeshBoundary boundary;
  for (std::size_t i = 0; i < input.loops.size(); ++i) {
    const Loop& loop = input.loops[i];
    if (loop.size() % 2 == 0) continue;
    const FaceReport::OddLoop odd{i + 1, loop.size(), {}};
    if (wanted && boundary.edges.empty()) boundary = boundaryOf(input);
    all.push_back(wanted ? withLongestSegment(odd, loop, boundary, *wanted) : odd);
  }
  return all;
}

}  // namespace af2::geometry
