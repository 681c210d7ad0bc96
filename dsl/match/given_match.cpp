#include "dsl/match/given_match.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/turn.h"

namespace af2::dsl {

GivenMatch::GivenMatch(const RuleDefinition& rule, std::vector<Point2> matched, int level,
                       std::map<std::string, double> environment)
    : rule_(rule),
      matched_(std::move(matched)),
      level_(level),
      environment_(std::move(environment)) {}

double GivenMatch::value(const std::string& name, double otherwise) const {
  const auto found = environment_.find(name);
  return found == environment_.end() ? otherwise : found->second;
}

double GivenMatch::ofVertex(const std::string& name, int vertex, double otherwise) const {
  const std::string& vertexName = rule_.vertices[static_cast<std::size_t>(vertex)].name;
  return value(name + "(" + vertexName + ")", value(name, otherwise));
}

std::optional<double> GivenMatch::turn(int vertex) const {
  const double given = ofVertex("turn", vertex, std::numeric_limits<double>::quiet_NaN());
  if (!std::isnan(given)) return given * std::numbers::pi / 180;
  const auto at = [&](int v) { return matched_[static_cast<std::size_t>(v)]; };
  std::optional<Point2> next, previous;
  for (const PatternEdge& edge : rule_.edges) {
    if (edge.from == vertex) next = at(edge.to);
    if (edge.to == vertex) previous = at(edge.from);
  }
  if (!next || !previous) return std::nullopt;
  const Point2 from = *next - at(vertex), to = *previous - at(vertex);
  return turnBetween(from, to);
}

}  // namespace af2::dsl
