#include "engine/step/clearance.h"

#include <algorithm>

#include "engine/base/segment.h"
#include "engine/step/matched_parts.h"

namespace af2 {
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
    const Point2 from = candidate.match.points[static_cast<std::size_t>(wanted.from)];
    const Point2 to = candidate.match.points[static_cast<std::size_t>(wanted.to)];
    const VertexId u = vertexOf(wanted.from), v = vertexOf(wanted.to);
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
