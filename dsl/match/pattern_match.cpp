#include "dsl/match/pattern_match.h"

namespace af2::dsl {

std::vector<Point2> cornersOf(const RuleElement& element, const std::vector<Point2>& placed) {
  std::vector<Point2> corners;
  for (int i = 0; i < element.size(); ++i) corners.push_back(placed[element.corners[i]]);
  return corners;
}

std::vector<std::vector<int>> chainsOf(const RuleDefinition& rule) {
  std::vector<PatternEdge> edges = rule.edges;
  std::vector<std::vector<int>> chains;
  while (!edges.empty()) {
    std::vector<int> chain{edges.front().from, edges.front().to};
    edges.erase(edges.begin());
    for (auto edge = edges.begin(); edge != edges.end();) {
      const bool isClosed = chain.front() == chain.back();
      if (!isClosed && edge->from == chain.back()) {
        chain.push_back(edge->to);
      } else if (!isClosed && edge->to == chain.front()) {
        chain.insert(chain.begin(), edge->from);
      } else {
        ++edge;
        continue;
      }
      edges.erase(edge);
      edge = edges.begin();
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

FrontPiece pieceOf(const PatternMatch& match, int level) {
  FrontPiece piece;
  piece.vertices = match.vertices();
  piece.base = {0, 1};
  piece.level = level;
  std::vector<bool> isInChain(piece.vertices.size());
  for (const auto& chain : chainsOf(match.rule().definition())) {
    piece.chains.emplace_back(chain.begin(), chain.end());
    for (const int vertex : chain) isInChain[vertex] = true;
  }
  for (std::size_t i = 0; i < isInChain.size(); ++i)
    if (!isInChain[i]) piece.isolated.push_back(i);
  return piece;
}

}  // namespace af2::dsl
