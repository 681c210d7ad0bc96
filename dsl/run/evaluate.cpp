#include "dsl/run/evaluate.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "dsl/match/given_match.h"
#include "dsl/program/shape_program.h"
#include "dsl/program/zone_corners.h"
#include "dsl/text/words.h"
#include "engine/base/error.h"
#include "engine/mesh/element_shape.h"

namespace af2::dsl {
namespace {

const AF2Rule& findRule(const RuleSet& rules, const std::string& title) {
  std::vector<std::string> titles;
  for (const AF2Rule& rule : rules.rules()) {
    if (rule.name() == title) return rule;
    titles.push_back(rule.name());
  }
  const std::string help = didYouMean(title, titles).text();
  throw InputError("there is no rule \"" + title + "\"" + (help.empty() ? "" : "; " + help));
}

void checkFinite(Point2 p, const std::string& what) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y))
    throw InputError(what + " is not at a finite position");
}

std::vector<Point2> matchedPositions(const RuleDefinition& rule, const EvalRequest& request) {
  std::vector<Point2> points;
  std::vector<std::string> names;
  for (const PatternVertex& vertex : rule.vertices) {
    const auto given = request.match.find(vertex.name);
    points.push_back(given == request.match.end() ? vertex.reference.at(request.level)
                                                  : given->second);
    names.push_back(vertex.name);
    checkFinite(points.back(), "vertex '" + vertex.name + "'");
  }
  for (const auto& [name, point] : request.match) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string help = didYouMean(name, names).text();
    throw InputError("rule \"" + rule.name + "\" matches no vertex '" + name + "'" +
                     (help.empty() ? "" : "; " + help));
  }
  return points;
}

/// Names that GivenMatch does not ask for.
void checkEnvironment(const RuleDefinition& rule, const EvalRequest& request) {
  std::vector<std::string> names{"h", "loop_size", "dist_front", "curvature"};
  for (const char* ofVertex : {"layer", "turn", "valence", "on_boundary"}) {
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

bool matches(const RuleDefinition& rule, const std::vector<Point2>& at, int level,
             double tolerance) {
  const auto isWithin = [&](const std::optional<ToleranceByLevel>& form, Point2 deviation) {
    return !form || form->at(level)(deviation) <= tolerance;
  };
  for (std::size_t i = 2; i < at.size(); ++i)
    if (!isWithin(rule.vertices[i].tolerance, at[i] - rule.vertices[i].reference.at(level)))
      return false;
  const auto of = [](int v) { return static_cast<std::size_t>(v); };
  return std::all_of(rule.edges.begin(), rule.edges.end(), [&](const PatternEdge& e) {
    const Point2 wanted =
        rule.vertices[of(e.to)].reference.at(level) - rule.vertices[of(e.from)].reference.at(level);
    return isWithin(e.slope, (at[of(e.to)] - at[of(e.from)]) - wanted);
  });
}

/// None, Require or NoValue.
Refusal requirement(const RuleDefinition& rule, const AF2Binding& binding) {
  for (const auto& condition : rule.requirements) {
    const auto value = condition->evaluate(binding);
    if (!value) return Refusal::NoValue;
    if (*value == 0) return Refusal::Require;
  }
  return Refusal::None;
}

/// Of a registered shape: nothing.
std::optional<Point2> firstPoint(const Shape& shape) {
  if (!shape.parts().empty()) return firstPoint(shape.parts().front());
  return shape.points().empty() ? std::nullopt : std::optional(shape.points().front());
}

/// A loop begins at the first corner that the shape is written with, if that is on it.
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
    auto corners = cornersAt(*list, binding);
    if (corners.empty()) return {};
    return {std::move(corners)};
  }
  if (const auto* free = dynamic_cast<const ShapeZoneDef*>(&zone))
    if (const auto shape = free->shapeAt(binding)) return outlineAsWritten(*shape);
  return {};
}

struct Scored {
  Refusal refusal = Refusal::None;
  std::optional<double> score;
};

Scored scoreOf(const RuleSetDefinition& set, const RuleDefinition& rule,
               const std::vector<Point2>& at, const AF2Binding& binding) {
  Scored result;
  double largest = 0, sum = 0;
  for (std::size_t i = 0; i < rule.elements.size(); ++i) {
    const RuleElement& element = rule.elements[i];
    std::vector<Point2> corners;
    for (int c = 0; c < element.size(); ++c)
      corners.push_back(at[static_cast<std::size_t>(element.corners[static_cast<std::size_t>(c)])]);
    if (!turnsLeftEverywhere(corners)) {
      result.refusal = Refusal::Inverted;
      return result;
    }
    const auto badness = set.metric->badnessAt(corners, binding.level);
    if (!badness) {
      result.refusal = Refusal::NoValue;
      return result;
    }
    largest = i == 0 ? *badness : std::max(largest, *badness);
    sum += *badness;
  }
  double score = largest;
  if (set.scoreOf == ScoreOf::Sum) score = sum;
  if (set.scoreOf == ScoreOf::Mean) score = sum / static_cast<double>(rule.elements.size());
  if (rule.cost) {
    const auto cost = rule.cost->evaluate(binding);
    if (!cost) {
      result.refusal = Refusal::NoValue;
      return result;
    }
    score += *cost;
  }
  result.score = score;
  if (set.acceptance && !set.acceptance->accepts(score, binding.level))
    result.refusal = Refusal::Score;
  return result;
}

nlohmann::ordered_json pointJson(Point2 p) { return nlohmann::ordered_json::array({p.x, p.y}); }

}  // namespace

EvalResult evaluateRule(const RuleSet& rules, const EvalRequest& request) {
  const AF2Rule& rule = findRule(rules, request.rule);
  const RuleDefinition& definition = rule.definition();
  if (request.level < 1 || request.level > rules.maxLevel())
    throw InputError("the level must lie between 1 and " + std::to_string(rules.maxLevel()));
  for (Point2 p : request.points) checkFinite(p, "a point");
  for (const auto& [p, q] : request.segments)
    checkFinite(p, "a segment"), checkFinite(q, "a segment");
  checkEnvironment(definition, request);

  const GivenMatch match(definition, matchedPositions(definition, request), request.level,
                         request.environment);
  const AF2Binding binding = match.binding();
  EvalResult result;
  const auto refuse = [&](Refusal reason) {
    if (result.refused == Refusal::None) result.refused = reason;
  };
  if (!rule.appliesAt(request.level)) refuse(Refusal::Class);
  result.matches =
      matches(definition, match.matched(), request.level, rules.matchTolerance(request.level));
  if (!result.matches) refuse(Refusal::Pattern);
  const Refusal required = requirement(definition, binding);
  result.requireHolds = required == Refusal::None;
  refuse(required);

  std::vector<Point2> all = match.matched();
  bool hasAll = true;
  for (std::size_t i = 0; i < definition.newVertices.size(); ++i) {
    const auto at = definition.newVertices[i]->transformPoint(binding);
    result.newVertices.emplace_back(definition.newVertexNames[i], at);
    hasAll = hasAll && at;
    if (at) all.push_back(*at);
  }
  if (!hasAll) refuse(Refusal::NoValue);

  const auto made = definition.zone->makeFreeZone(binding);
  if (!made.zone) refuse(made.refusal);
  result.zones = drawn(*definition.zone, binding);
  for (Point2 p : request.points)
    result.pointsInZone.push_back(made.zone && made.zone->contains(p, ZoneBoundary::Counts));
  for (const auto& [p, q] : request.segments)
    result.segmentsMeetZone.push_back(made.zone && made.zone->meets(p, q, ZoneBoundary::Ignored));

  if (hasAll) {
    const Scored scored = scoreOf(rules.definition(), definition, all, binding);
    result.score = scored.score;
    refuse(scored.refusal);
  }
  return result;
}

std::string toJson(const EvalResult& result) {
  nlohmann::ordered_json json;
  if (result.refused == Refusal::None)
    json["refused"] = nullptr;
  else
    json["refused"] = toString(result.refused);
  json["matches"] = result.matches;
  json["require"] = result.requireHolds;
  json["new"] = nlohmann::ordered_json::object();
  for (const auto& [name, at] : result.newVertices) {
    if (at)
      json["new"][name] = pointJson(*at);
    else
      json["new"][name] = nullptr;
  }
  json["zones"] = nlohmann::ordered_json::array();
  for (const auto& zone : result.zones) {
    auto loop = nlohmann::ordered_json::array();
    for (Point2 p : zone) loop.push_back(pointJson(p));
    json["zones"].push_back(std::move(loop));
  }
  json["points_in_zone"] = result.pointsInZone;
  json["segments_meet_zone"] = result.segmentsMeetZone;
  if (result.score)
    json["score"] = *result.score;
  else
    json["score"] = nullptr;
  return json.dump(2) + "\n";
}

std::string toText(const EvalResult& result) {
  const auto shown = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", value);
    return std::string(text);
  };
  const auto point = [&](Point2 p) { return "(" + shown(p.x) + ", " + shown(p.y) + ")"; };
  std::string text = std::string("refused   ") +
                     (result.refused == Refusal::None ? "no" : toString(result.refused)) + "\n";
  text += std::string("matches   ") + (result.matches ? "yes" : "no") + "\n";
  text += std::string("require   ") + (result.requireHolds ? "holds" : "does not hold") + "\n";
  for (const auto& [name, at] : result.newVertices)
    text += "new " + name + "     " + (at ? point(*at) : "no value") + "\n";
  for (const auto& zone : result.zones) {
    text += "zone     ";
    for (Point2 p : zone) text += " " + point(p);
    text += "\n";
  }
  for (bool b : result.pointsInZone)
    text += std::string("point     ") + (b ? "in the zone" : "outside of the zone") + "\n";
  for (bool b : result.segmentsMeetZone)
    text += std::string("segment   ") + (b ? "meets the zone" : "keeps clear of the zone") + "\n";
  text += "score     " + (result.score ? shown(*result.score) : "none") + "\n";
  return text;
}

}  // namespace af2::dsl
