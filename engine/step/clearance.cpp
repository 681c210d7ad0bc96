#include "engine/step/clearance.h"

#include <algorithm>
#include <utility>

#include "engine/base/segment.h"
#include "engine/step/matched_parts.h"

namespace af2 {
namespace {

/// Next to a vertex that is on the front already, an edge cannot help being as close to other edges
/// as the vertex is: half of the edge does not count there.
std::pair<Point2, Point2> newPart(Point2 from, Point2 to, bool isFromOld, bool isToOld) {
  const double share = isFromOld && isToOld ? 0.25 : 0.5;
  const Point2 edge = to - from;
  return {isFromOld ? from + share * edge : from, isToOld ? to - share * edge : to};
}

}  // namespace

Window clearanceWindow(const Candidate& candidate, double clearance) {
  Window window;
  for (const PatternEdge& edge : candidate.rule->rule->newEdges())
    for (const int end : {edge.from, edge.to}) {
      const Point2 p = candidate.match.points[static_cast<std::size_t>(end)];
      window.include(p.x, p.y);
    }
  return window.widened(clearance);
}

const Neighborhood::Edge* tooCloseEdge(const Front& front, const Neighborhood& near,
                                       const Candidate& candidate, double clearance) {
  const MatchedParts matched(front, candidate);
  const auto vertexOf = [&](int v) {
    return v < candidate.rule->matchedCount ? matched.vertex(static_cast<std::size_t>(v))
                                            : VertexId();
  };
  for (const PatternEdge& wanted : candidate.rule->rule->newEdges()) {
    const VertexId u = vertexOf(wanted.from), v = vertexOf(wanted.to);
    const auto [from, to] = newPart(candidate.match.points[static_cast<std::size_t>(wanted.from)],
                                    candidate.match.points[static_cast<std::size_t>(wanted.to)],
                                    !u.isNone(), !v.isNone());
    for (const Neighborhood::Edge& edge : near.edges()) {
      if (!areCloser(clearance, from, to, edge.from, edge.to)) continue;
      const VertexId end = edge.isEdge ? front[front.next(edge.place)].vertex : edge.vertex;
      if (edge.vertex == u || edge.vertex == v || end == u || end == v) continue;
      if (!edge.isEdge && matched.holdVertex(edge.vertex)) continue;
      if (edge.isEdge && matched.holdEdge(edge.place)) continue;
      return &edge;
    }
  }
  return nullptr;
}

}  // namespace af2
