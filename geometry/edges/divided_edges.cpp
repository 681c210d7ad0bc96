#include "geometry/edges/divided_edges.h"

namespace af2::geometry {

std::size_t DividedEdges::segmentCount() const {
  std::size_t count = 0;
  for (const DividedEdge& edge : edges)
    if (!edge.points.empty()) count += edge.points.size() - 1;
  return count;
}

DivisionChange compare(const DividedEdges& before, const DividedEdges& after) {
  DivisionChange change;
  change.newIndex.assign(before.points.size(), 0);
  // Model vertices, and the ends that edges without vertices got, come first and do not depend on
  // sizes.
  for (std::uint32_t i = 0; i < change.newIndex.size(); ++i) change.newIndex[i] = i;
  for (std::size_t e = 0; e < before.edges.size(); ++e) {
    const DividedEdge &was = before.edges[e], &is = after.edges[e];
    const auto sameEnds = [&] {
      return was.points.empty() ||
             (was.points.front() == is.points.front() && was.points.back() == is.points.back());
    };
    change.isChanged.push_back(was.parameters != is.parameters || was.point != is.point ||
                               !sameEnds());
    if (change.isChanged.back()) continue;
    for (std::size_t k = 0; k < was.points.size(); ++k)
      change.newIndex[was.points[k]] = is.points[k];
  }
  return change;
}

}  // namespace af2::geometry
