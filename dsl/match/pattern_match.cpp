#include "dsl/match/pattern_match.h"

#include <cmath>

#include "engine/base/turn.h"

namespace af2::dsl {

PatternMatch::PatternMatch(const AF2Rule& rule, std::vector<Point2> vertices, int level)
    : rule_(&rule), vertices_(std::move(vertices)), level_(level) {}

PatternMatch PatternMatch::atReference(const AF2Rule& rule, int level) {
  std::vector<Point2> vertices;
  for (const PatternVertex& vertex : rule.definition().vertices)
    vertices.push_back(vertex.reference.at(level));
  return PatternMatch(rule, std::move(vertices), level);
}

std::optional<double> PatternMatch::turn(int vertex) const {
  std::optional<Point2> previous, next;
  for (const PatternEdge& edge : rule_->definition().edges) {
    if (edge.from == vertex) next = vertices_[edge.to];
    if (edge.to == vertex) previous = vertices_[edge.from];
  }
  if (!previous || !next) return std::nullopt;
  const Point2 from = *next - vertices_[vertex], to = *previous - vertices_[vertex];
  return turnBetween(from, to);
}

std::optional<std::vector<Point2>> PatternMatch::placeAll() const {
  std::vector<Point2> placed = vertices_;
  for (const auto& transform : rule_->definition().newVertices) {
    const auto point = transform->transformPoint(binding());
    if (!point) return std::nullopt;
    placed.push_back(*point);
  }
  return placed;
}

Refusal PatternMatch::refusalOfMatch(const RuleSet& rules) const {
  const RuleDefinition& definition = rule_->definition();
  if (!rule_->appliesAt(level_)) return Refusal::Class;
  const auto isWithin = [&, tolerance = rules.matchTolerance(level_)](
                            const std::optional<ToleranceByLevel>& form, Point2 deviation) {
    return !form || form->at(level_)(deviation) <= tolerance;
  };
  for (std::size_t i = 2; i < vertices_.size(); ++i) {
    const PatternVertex& vertex = definition.vertices[i];
    if (!isWithin(vertex.tolerance, vertices_[i] - vertex.reference.at(level_)))
      return Refusal::Pattern;
  }
  for (const PatternEdge& edge : definition.edges) {
    const Point2 reference = definition.vertices[edge.to].reference.at(level_) -
                             definition.vertices[edge.from].reference.at(level_);
    if (!isWithin(edge.slope, vertices_[edge.to] - vertices_[edge.from] - reference))
      return Refusal::Pattern;
  }
  for (const auto& requirement : definition.requirements) {
    const auto value = requirement->evaluate(binding());
    if (!value) return Refusal::NoValue;
    if (*value == 0) return Refusal::Require;
  }
  return Refusal::None;
}

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
