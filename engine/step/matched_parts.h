// The vertices and edges of the front that a candidate has matched.
// Not installed.
#pragma once

#include <array>

#include "engine/front/front.h"
#include "engine/step/candidate_score.h"

namespace af2 {

class MatchedParts {
 public:
  MatchedParts(const Front& front, const Candidate& c)
      : vertexCount_(static_cast<std::size_t>(c.rule->matchedCount)) {
    for (std::size_t v = 0; v < vertexCount_; ++v) vertices_[v] = front[c.match.places[v]].vertex;
    for (const PatternEdge& e : c.rule->rule->definition().edges)
      edges_[edgeCount_++] = c.match.places[static_cast<std::size_t>(e.from)];
  }
  bool holdVertex(VertexId id) const { return holds(vertices_, vertexCount_, id); }
  bool holdEdge(PlaceId id) const { return holds(edges_, edgeCount_, id); }
  VertexId vertex(std::size_t matched) const { return vertices_[matched]; }

 private:
  template <class Id>
  static bool holds(const std::array<Id, AF2Rule::kMaxVertices>& ids, std::size_t count, Id id) {
    bool isFound = false;
    for (std::size_t i = 0; i < count; ++i) isFound |= ids[i] == id;
    return isFound;
  }

  std::array<VertexId, AF2Rule::kMaxVertices> vertices_;
  std::array<PlaceId, AF2Rule::kMaxVertices> edges_;
  std::size_t vertexCount_, edgeCount_ = 0;
};

}  // namespace af2
