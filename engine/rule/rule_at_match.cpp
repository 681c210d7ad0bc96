#include "engine/rule/rule_at_match.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/segment.h"
#include "engine/base/turn.h"

namespace af2 {

namespace {

/// Whether the i-th vertex is too far from its computed place.
RefusalCause farFrom(const NearPlace& near, std::size_t i, const AF2Binding& binding) {
  const auto place = near.place->transformPoint(binding);
  if (!place) return {Refusal::NoValue, static_cast<int>(i)};
  const double away = distance(*place, binding.vertices[i]), reach = near.reach.at(binding.level);
  if (away <= reach) return {};
  return {Refusal::Pattern, static_cast<int>(i), false, away, reach};
}

}  // namespace

RefusalCause patternMisfit(const RuleDefinition& rule, const AF2Binding& binding,
                           double tolerance) {
  const auto of = [](int v) { return static_cast<std::size_t>(v); };
  const std::span<const Point2> matched = binding.vertices;
  const int level = binding.level;
  for (std::size_t i = 2; i < rule.vertices.size(); ++i) {
    const PatternVertex& vertex = rule.vertices[i];
    if (vertex.near) {
      const RefusalCause far = farFrom(*vertex.near, i, binding);
      if (!far.isNone()) return far;
      continue;
    }
    if (!vertex.tolerance) continue;
    const ToleranceForm& form = vertex.tolerance->at(level);
    const Point2 deviation = matched[i] - vertex.reference.at(level);
    if (!form.allows(deviation, tolerance))
      return {Refusal::Pattern, static_cast<int>(i), false, form(deviation), tolerance};
  }
  for (std::size_t i = 0; i < rule.edges.size(); ++i) {
    const PatternEdge& edge = rule.edges[i];
    if (!edge.slope) continue;
    const ToleranceForm& form = edge.slope->at(level);
    const Point2 wanted = rule.vertices[of(edge.to)].reference.at(level) -
                          rule.vertices[of(edge.from)].reference.at(level);
    const Point2 deviation = (matched[of(edge.to)] - matched[of(edge.from)]) - wanted;
    if (!form.allows(deviation, tolerance))
      return {Refusal::Pattern, static_cast<int>(i), true, form(deviation), tolerance};
  }
  return {};
}

RefusalCause failedRequirement(const RuleDefinition& rule, const AF2Binding& binding) {
  for (std::size_t i = 0; i < rule.requirements.size(); ++i) {
    const auto value = rule.requirements[i]->evaluate(binding);
    if (!value) return {Refusal::NoValue, static_cast<int>(i)};
    if (*value == 0) return {Refusal::Require, static_cast<int>(i)};
  }
  return {};
}

std::optional<Point2> newVertexAt(const RuleDefinition& rule, std::size_t index,
                                  const AF2Binding& binding) {
  const auto point = rule.newVertices[index]->transformPoint(binding);
  return point && std::isfinite(point->x) && std::isfinite(point->y) ? point : std::nullopt;
}

std::vector<std::optional<Point2>> newVerticesAt(const RuleDefinition& rule,
                                                 const AF2Binding& binding) {
  std::vector<std::optional<Point2>> places;
  for (std::size_t i = 0; i < rule.newVertices.size(); ++i)
    places.push_back(newVertexAt(rule, i, binding));
  return places;
}

std::optional<double> costAt(const RuleDefinition& rule, const AF2Binding& binding) {
  if (!rule.cost) return 0;
  const auto cost = rule.cost->evaluate(binding);
  return cost && std::isfinite(*cost) ? cost : std::nullopt;
}

RuleAtMatch::RuleAtMatch(const RuleDefinition& rule, std::vector<Point2> vertices, int level)
    : definition_(&rule), vertices_(std::move(vertices)), level_(level) {}

RuleAtMatch RuleAtMatch::atReference(const RuleDefinition& rule, int level) {
  std::vector<Point2> vertices{{0, 0}, {1, 0}};
  for (std::size_t i = 2; i < rule.vertices.size(); ++i)
    vertices.push_back(rule.vertices[i].reference.at(level));
  return RuleAtMatch(rule, std::move(vertices), level);
}

std::optional<std::vector<Point2>> RuleAtMatch::placeAll() const {
  std::vector<Point2> placed = vertices_;
  for (std::size_t i = 0; i < definition_->newVertices.size(); ++i) {
    const auto point = newVertexAt(*definition_, i, binding());
    if (!point) return std::nullopt;
    placed.push_back(*point);
  }
  return placed;
}

int RuleAtMatch::previousOf(int vertex) const {
  const auto edge = std::ranges::find(definition_->edges, vertex, &PatternEdge::to);
  return edge == definition_->edges.end() ? -1 : edge->from;
}

int RuleAtMatch::nextOf(int vertex) const {
  const auto edge = std::ranges::find(definition_->edges, vertex, &PatternEdge::from);
  return edge == definition_->edges.end() ? -1 : edge->to;
}

std::optional<double> RuleAtMatch::turn(int vertex) const {
  const int next = nextOf(vertex), previous = previousOf(vertex);
  if (next < 0 || previous < 0) return std::nullopt;
  return turnBetween(at(next) - at(vertex), at(previous) - at(vertex));
}

std::optional<Point2> RuleAtMatch::before(int vertex) const {
  if (const int v = previousOf(vertex); v >= 0) return at(v);
  const int next = nextOf(vertex);
  return next >= 0 ? 2 * at(vertex) - at(next) : at(vertex) + (at(1) - at(0));
}

std::optional<Point2> RuleAtMatch::after(int vertex) const {
  if (const int v = nextOf(vertex); v >= 0) return at(v);
  const int previous = previousOf(vertex);
  return previous >= 0 ? 2 * at(vertex) - at(previous) : at(vertex) - (at(1) - at(0));
}

int RuleAtMatch::loopSize() const {
  int count = 1, v = nextOf(0);
  for (; v > 0; v = nextOf(v)) ++count;
  if (v == 0) return count;  // a closed chain
  for (v = previousOf(0); v >= 0; v = previousOf(v)) ++count;
  return count;
}

double RuleAtMatch::distanceToFront(Point2 point) const {
  double nearest = distanceToSegment(point, at(0), at(1));
  for (const PatternEdge& edge : definition_->edges)
    nearest = std::min(nearest, distanceToSegment(point, at(edge.from), at(edge.to)));
  return nearest;
}

}  // namespace af2
