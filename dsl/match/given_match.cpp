#include "dsl/match/given_match.h"

#include <numbers>
#include <utility>

namespace af2::dsl {

GivenMatch::GivenMatch(const RuleDefinition& rule, std::vector<Point2> matched, int level,
                       std::map<std::string, double> environment)
    : RuleAtMatch(rule, std::move(matched), level), environment_(std::move(environment)) {}

std::optional<double> GivenMatch::given(const std::string& name) const {
  const auto found = environment_.find(name);
  return found == environment_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> GivenMatch::given(const std::string& name, int vertex) const {
  const std::string& vertexName = definition().vertices[static_cast<std::size_t>(vertex)].name;
  const auto ofVertex = given(name + "(" + vertexName + ")");
  return ofVertex ? ofVertex : given(name);
}

double GivenMatch::size(Point2 point) const {
  return given("h").value_or(RuleAtMatch::size(point));
}

double GivenMatch::sizeOf(int vertex) const {
  return given("h").value_or(RuleAtMatch::sizeOf(vertex));
}

std::optional<double> GivenMatch::turn(int vertex) const {
  const auto degrees = given("turn", vertex);
  return degrees ? *degrees * std::numbers::pi / 180 : RuleAtMatch::turn(vertex);
}

int GivenMatch::layer(int vertex) const {
  return static_cast<int>(given("layer", vertex).value_or(RuleAtMatch::layer(vertex)));
}

bool GivenMatch::onBoundary(int vertex) const {
  return given("on_boundary", vertex).value_or(layer(vertex) == 0) != 0;
}

bool GivenMatch::isFixed(int vertex) const {
  return given("fixed", vertex).value_or(onBoundary(vertex)) != 0;
}

int GivenMatch::count(int vertex, const std::array<double, 3>& bounds) const {
  const auto count = given("count", vertex);
  return count ? static_cast<int>(*count) : RuleAtMatch::count(vertex, bounds);
}

int GivenMatch::valence(int vertex) const {
  return static_cast<int>(given("valence", vertex).value_or(RuleAtMatch::valence(vertex)));
}

int GivenMatch::loopSize() const {
  return static_cast<int>(given("loop_size").value_or(RuleAtMatch::loopSize()));
}

double GivenMatch::distanceToFront(Point2 point) const {
  return given("dist_front").value_or(RuleAtMatch::distanceToFront(point));
}

double GivenMatch::curvature(Point2 point) const {
  return given("curvature").value_or(RuleAtMatch::curvature(point));
}

}  // namespace af2::dsl
