#include "dsl/run/evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "dsl/match/given_match.h"
#include "dsl/program/shape_program.h"
#include "dsl/text/words.h"
#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "engine/step/rule_evaluation.h"

namespace af2::dsl {
namespace {

void checkFinite(Point2 p, const std::string& what) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y))
    throw InputError(what + " is not at a finite position");
}

constexpr int kShortDigits = 4;  // of numbers in sentences
constexpr std::array kFactsOfVertices{"layer", "turn", "count", "valence", "on_boundary", "fixed"};

/// Throws InputError on names that GivenMatch does not use.
void checkEnvironment(const RuleDefinition& rule, const EvalRequest& request) {
  std::vector<std::string> names{"h", "loop_size", "dist_front", "curvature"};
  for (const char* ofVertex : kFactsOfVertices) {
    names.emplace_back(ofVertex);
    for (const PatternVertex& vertex : rule.vertices)
      names.push_back(std::string(ofVertex) + "(" + vertex.name + ")");
  }
  for (const auto& [name, value] : request.environment) {
    if (std::ranges::find(names, name) != names.end()) continue;
    const std::string help = didYouMean(name, names).text();
    throw InputError("the environment has no '" + name + "'; " +
                     (help.empty() ? "there are h, loop_size, dist_front, curvature, and of a "
                                     "vertex c layer(c), turn(c), valence(c), on_boundary(c)"
                                   : help));
  }
}

/// Empty for a registered shape, which has no known outline.
std::optional<Point2> firstPoint(const Shape& shape) {
  if (!shape.parts().empty()) return firstPoint(shape.parts().front());
  return shape.points().empty() ? std::nullopt : std::optional(shape.points().front());
}

/// A loop begins at the first corner in the text of the shape, if that corner is on the loop.
std::vector<std::vector<Point2>> outlineAsWritten(const Shape& shape) {
  auto loops = outline(shape);
  const auto wanted = firstPoint(shape);
  if (!wanted) return loops;
  for (std::vector<Point2>& loop : loops)
    if (const auto first = std::ranges::find(loop, *wanted); first != loop.end())
      std::rotate(loop.begin(), first, loop.end());
  return loops;
}

std::vector<std::vector<Point2>> drawn(const AF2FreeZoneDef& zone, const AF2Binding& binding) {
  if (const auto* list = dynamic_cast<const ConvexPolygonZoneDef*>(&zone)) {
    auto corners = list->cornersAt(binding);
    if (!corners) return {};
    return {std::move(*corners)};
  }
  if (const auto* free = dynamic_cast<const ShapeZoneDef*>(&zone))
    if (const auto shape = free->shapeAt(binding)) return outlineAsWritten(*shape);
  return {};
}

std::string patternSentence(const RuleDefinition& rule, const RefusalCause& cause) {
  const auto index = static_cast<std::size_t>(cause.index);
  const auto name = [&](int v) { return rule.vertices[static_cast<std::size_t>(v)].name; };
  const std::string part = cause.isEdge ? "the slope of " + name(rule.edges[index].from) + " -> " +
                                              name(rule.edges[index].to)
                                        : "vertex " + rule.vertices[index].name;
  return part + " deviates by " + textOf(cause.value, kShortDigits) +
         " from its reference; at most " + textOf(cause.limit, kShortDigits) + " is allowed";
}

std::string levelSentence(const RuleDefinition& rule, int level) {
  return "level " + std::to_string(level) + " is not one of the rule's, " +
         std::to_string(rule.firstLevel) + ".." +
         (rule.lastLevel ? std::to_string(*rule.lastLevel) : std::string());
}

/// The numbers behind a refusal.
std::string sentence(const RuleDefinition& rule, const RuleEvaluation& evaluation, int level) {
  const RefusalCause& cause = evaluation.refused;
  const std::string number = std::to_string(cause.index + 1);
  switch (cause.reason) {
    case Refusal::Class:
      return levelSentence(rule, level);
    case Refusal::Pattern:
      return patternSentence(rule, cause);
    case Refusal::Require:
      return "condition " + number + " does not hold";
    case Refusal::NoValue:
      return cause.index < 0 ? "" : "condition " + number + " has no value";
    case Refusal::Inverted:
      return "element " + number + " does not turn left at each corner";
    case Refusal::Score:
      return "the rule set does not accept a score of " + textOf(*evaluation.score, kShortDigits) +
             " at level " + std::to_string(level);
    default:
      return {};
  }
}

/// What the rule says besides new vertices and elements, at this match.
EvaluatedActs actsOf(const RuleDefinition& rule, const AF2Binding& binding) {
  const auto nameOf = [&](int v) { return rule.vertices[static_cast<std::size_t>(v)].name; };
  EvaluatedActs acts;
  for (std::size_t i = 0; i < rule.vertices.size(); ++i) {
    const auto& near = rule.vertices[i].near;
    if (!near) continue;
    const auto place = near->place->transformPoint(binding);
    acts.near.push_back(
        {rule.vertices[i].name, place, near->reach.at(binding.level),
         place ? std::optional(distance(*place, binding.vertices[i])) : std::nullopt});
  }
  if (const auto& weld = rule.weld)
    acts.weld = {nameOf(weld->from), nameOf(weld->into), weld->place->transformPoint(binding)};
  if (rule.path) acts.path = {nameOf(0), nameOf(2), rule.path->segments->evaluate(binding)};
  return acts;
}

}  // namespace

const AF2Rule& findRule(const RuleSet& rules, const std::string& title) {
  std::vector<std::string> titles;
  for (const AF2Rule& rule : rules.rules()) {
    if (rule.name() == title) return rule;
    titles.push_back(rule.name());
  }
  const std::string help = didYouMean(title, titles).text();
  throw InputError("there is no rule \"" + title + "\"" + (help.empty() ? "" : "; " + help));
}

std::vector<Point2> matchedPositions(const RuleDefinition& rule,
                                     const std::map<std::string, Point2>& match, int level) {
  std::vector<Point2> points;
  std::vector<std::string> names;
  for (const PatternVertex& vertex : rule.vertices) {
    const auto given = match.find(vertex.name);
    points.push_back(given == match.end() ? vertex.reference.at(level) : given->second);
    names.push_back(vertex.name);
    checkFinite(points.back(), "vertex '" + vertex.name + "'");
  }
  for (const auto& [name, point] : match) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string help = didYouMean(name, names).text();
    throw InputError("rule \"" + rule.name + "\" matches no vertex '" + name + "'" +
                     (help.empty() ? "" : "; " + help));
  }
  return points;
}

EvalResult evaluateRule(const RuleSet& rules, const EvalRequest& request) {
  const AF2Rule& rule = findRule(rules, request.rule);
  const RuleDefinition& definition = rule.definition();
  if (request.level < 1 || request.level > rules.maxLevel())
    throw InputError("the level must lie between 1 and " + std::to_string(rules.maxLevel()));
  for (Point2 p : request.points) checkFinite(p, "a point");
  for (const auto& [p, q] : request.segments)
    checkFinite(p, "a segment"), checkFinite(q, "a segment");
  checkEnvironment(definition, request);

  const GivenMatch match(definition, matchedPositions(definition, request.match, request.level),
                         request.level, request.environment);
  const RuleEvaluation evaluation = evaluateMatch(rules, rule, match.binding());
  EvalResult result;
  result.refused = evaluation.refused.reason;
  result.cause = evaluation.refused;
  result.because = sentence(definition, evaluation, request.level);
  result.matches = evaluation.misfit.isNone();
  result.requireHolds = evaluation.required.isNone();
  for (std::size_t i = 0; i < definition.newVertices.size(); ++i)
    result.newVertices.emplace_back(definition.newVertexNames[i], evaluation.newVertices[i]);
  result.acts = actsOf(definition, match.binding());
  result.zones = drawn(*definition.zone, match.binding());
  const AF2FreeZone* zone = evaluation.zone.zone.get();
  for (Point2 p : request.points)
    result.pointsInZone.push_back(zone && zone->contains(p, ZoneBoundary::Counts));
  for (const auto& [p, q] : request.segments)
    result.segmentsMeetZone.push_back(zone && zone->meets(p, q, ZoneBoundary::Ignored));
  result.score = evaluation.score;
  return result;
}

}  // namespace af2::dsl
