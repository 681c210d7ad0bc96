#include "dsl/checks/rule_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>
#include <span>

#include "engine/rule/rule_at_match.h"
#include "engine/step/rule_scoring.h"

namespace af2::dsl {
namespace {

constexpr double kSame = 1e-9;  // both sides are results of the same formulas, up to rounding

/// For each vertex of one rule, matched or new, the corresponding vertex of the other rule; empty
/// if the rules do not correspond.
using Renumbering = std::vector<int>;

bool isNear(Point2 p, Point2 q) {
  return std::abs(p.x - q.x) <= kSame && std::abs(p.y - q.y) <= kSame;
}

bool isSameForm(const ToleranceForm& a, const ToleranceForm& b) {
  return std::abs(a.xx - b.xx) <= kSame && std::abs(a.xy - b.xy) <= kSame &&
         std::abs(a.yy - b.yy) <= kSame;
}

bool isSameForm(const std::optional<ToleranceByLevel>& a,
                const std::optional<ToleranceByLevel>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  for (int level = std::max(a->levelCount(), b->levelCount()); level > 0; --level)
    if (!isSameForm(a->at(level), b->at(level))) return false;
  return true;
}

bool isNear(const ReferenceByLevel& p, const ReferenceByLevel& q) {
  for (int level = std::max(p.levelCount(), q.levelCount()); level > 0; --level)
    if (!isNear(p.at(level), q.at(level))) return false;
  return true;
}

std::optional<Renumbering> matchVertices(const RuleDefinition& a, const RuleDefinition& b) {
  if (a.vertices.size() != b.vertices.size() || a.newVertices.size() != b.newVertices.size())
    return std::nullopt;
  Renumbering to{0, 1};
  std::set<int> taken{0, 1};
  for (std::size_t i = 2; i < a.vertices.size(); ++i) {
    int found = -1;
    for (std::size_t k = 2; k < b.vertices.size() && found < 0; ++k)
      if (!taken.contains(static_cast<int>(k)) &&
          isNear(a.vertices[i].reference, b.vertices[k].reference))
        found = static_cast<int>(k);
    if (found < 0) return std::nullopt;
    taken.insert(found);
    to.push_back(found);
  }
  return to;
}

/// Fixed deviations, all different, without special values.
double deviation(std::size_t sample, std::size_t coordinate) {
  if (sample == 0) return 0;
  const double x = 0.6180339887498949 * static_cast<double>(7 * sample + coordinate + 1);
  return 0.3 * (x - std::floor(x) - 0.5);
}

std::vector<Point2> matchOf(const RuleDefinition& rule, int level, std::size_t sample) {
  std::vector<Point2> points{{0, 0}, {1 + deviation(sample, 0), 0}};
  for (std::size_t i = 2; i < rule.vertices.size(); ++i)
    points.push_back(rule.vertices[i].reference.at(level) +
                     Point2{deviation(sample, 2 * i), deviation(sample, 2 * i + 1)});
  return points;
}

std::vector<Point2> renumbered(const std::vector<Point2>& points, const Renumbering& to) {
  std::vector<Point2> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    result[static_cast<std::size_t>(to[i])] = points[i];
  return result;
}

bool isSamePlace(const std::optional<Point2>& p, const std::optional<Point2>& q) {
  return p && q ? isNear(*p, *q) : p.has_value() == q.has_value();
}

bool matchNewVertices(const RuleDefinition& a, const RuleDefinition& b, Renumbering& to) {
  const std::size_t matched = a.vertices.size();
  const RuleAtMatch here(a, matchOf(a, a.firstLevel, 1), a.firstLevel),
      there(b, renumbered(here.vertices(), to), a.firstLevel);
  const auto placesA = newVerticesAt(a, here.binding()),
             placesB = newVerticesAt(b, there.binding());
  std::set<std::size_t> taken;
  for (const auto& place : placesA) {
    std::size_t found = placesB.size();
    for (std::size_t k = 0; k < placesB.size(); ++k)
      if (!taken.contains(k) && isSamePlace(place, placesB[k])) found = std::min(found, k);
    if (found == placesB.size()) return false;
    taken.insert(found);
    to.push_back(static_cast<int>(matched + found));
  }
  return true;
}

std::set<std::vector<int>> elementsOf(const RuleDefinition& rule, const Renumbering& to) {
  std::set<std::vector<int>> result;
  for (const RuleElement& element : rule.elements) {
    std::vector<int> corners;
    for (int c = 0; c < element.size(); ++c) {
      const auto vertex = static_cast<std::size_t>(element.corners[static_cast<std::size_t>(c)]);
      corners.push_back(to.empty() ? static_cast<int>(vertex) : to[vertex]);
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert(std::move(corners));
  }
  return result;
}

bool haveSameEdges(const RuleDefinition& a, const RuleDefinition& b, const Renumbering& to) {
  if (a.edges.size() != b.edges.size()) return false;
  return std::all_of(a.edges.begin(), a.edges.end(), [&](const PatternEdge& e) {
    const int from = to[static_cast<std::size_t>(e.from)], end = to[static_cast<std::size_t>(e.to)];
    return std::any_of(b.edges.begin(), b.edges.end(), [&](const PatternEdge& other) {
      return other.from == from && other.to == end && isSameForm(e.slope, other.slope);
    });
  });
}

bool haveSameTolerances(const RuleDefinition& a, const RuleDefinition& b, const Renumbering& to) {
  for (std::size_t i = 2; i < a.vertices.size(); ++i)
    if (!isSameForm(a.vertices[i].tolerance, b.vertices[static_cast<std::size_t>(to[i])].tolerance))
      return false;
  return true;
}

bool haveSameCosts(const RuleDefinition& a, const RuleDefinition& b, const AF2Binding& here,
                   const AF2Binding& there) {
  const auto costA = costAt(a, here), costB = costAt(b, there);
  return costA && costB ? std::abs(*costA - *costB) <= kSame
                        : costA.has_value() == costB.has_value();
}

bool haveSamePoints(std::span<const Point2> first, std::span<const Point2> second) {
  return std::ranges::all_of(first, [&](Point2 p) {
    return std::ranges::any_of(second, [&](Point2 q) { return isNear(p, q); });
  });
}

bool haveSameZones(const RuleDefinition& a, const RuleDefinition& b, const AF2Binding& here,
                   const AF2Binding& there) {
  const auto zoneA = a.zone->makeFreeZone(here), zoneB = b.zone->makeFreeZone(there);
  if (!zoneA.zone || !zoneB.zone) return !zoneA.zone && !zoneB.zone;
  const auto* polygonA = dynamic_cast<const ConvexPolygonZone*>(zoneA.zone.get());
  const auto* polygonB = dynamic_cast<const ConvexPolygonZone*>(zoneB.zone.get());
  if (polygonA && polygonB)
    return haveSamePoints(polygonA->corners(), polygonB->corners()) &&
           haveSamePoints(polygonB->corners(), polygonA->corners());
  constexpr std::size_t kPoints = 150;
  const Box2 boxA = zoneA.zone->boundingBox(), boxB = zoneB.zone->boundingBox();
  const Point2 low{std::min(boxA.low.x, boxB.low.x), std::min(boxA.low.y, boxB.low.y)};
  const Point2 high{std::max(boxA.high.x, boxB.high.x), std::max(boxA.high.y, boxB.high.y)};
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double s = 0.5 + deviation(i + 1, 3) / 0.3, t = 0.5 + deviation(i + 1, 5 + i) / 0.3;
    const Point2 p{low.x + s * (high.x - low.x), low.y + t * (high.y - low.y)};
    if (zoneA.zone->contains(p, ZoneBoundary::Counts) !=
        zoneB.zone->contains(p, ZoneBoundary::Counts))
      return false;
  }
  return true;
}

bool agreeAtMatches(const RuleDefinition& a, const RuleDefinition& b, const Renumbering& to) {
  const std::size_t matched = a.vertices.size();
  const Renumbering matchedTo(to.begin(), to.begin() + static_cast<std::ptrdiff_t>(matched));
  for (std::size_t sample = 0; sample < 4; ++sample) {
    for (int level : {a.firstLevel, a.firstLevel + 2}) {
      const RuleAtMatch here(a, matchOf(a, level, sample), level),
          there(b, renumbered(here.vertices(), matchedTo), level);
      const auto placesA = newVerticesAt(a, here.binding()),
                 placesB = newVerticesAt(b, there.binding());
      for (std::size_t i = 0; i < placesA.size(); ++i)
        if (!isSamePlace(placesA[i], placesB[static_cast<std::size_t>(to[matched + i]) - matched]))
          return false;
      if (failedRequirement(a, here.binding()).isNone() !=
          failedRequirement(b, there.binding()).isNone())
        return false;
      if (!haveSameCosts(a, b, here.binding(), there.binding())) return false;
      if (!haveSameZones(a, b, here.binding(), there.binding())) return false;
    }
  }
  return true;
}

bool haveSameScores(const RuleAtMatch& here, const std::vector<RuleElement>& elements,
                    const RuleAtMatch& there, const std::vector<RuleElement>& otherElements,
                    const RuleSetDefinition& settings) {
  const auto vertices = here.placeAll(), otherVertices = there.placeAll();
  if (!vertices || !otherVertices) return !vertices && !otherVertices;
  const RuleScoring scoring(settings);
  double score = 0, other = 0;
  const Refusal refusal = scoring.scoreElements(elements, vertices->data(), here.level(), score);
  if (refusal != scoring.scoreElements(otherElements, otherVertices->data(), there.level(), other))
    return false;
  return refusal != Refusal::None ||
         std::abs(score - other) <= kSame * std::max(1.0, std::abs(score));
}

/// The largest distance of a point of one list from the nearest point of the other; infinite if one
/// list is empty.
double distanceOf(const std::vector<Point2>& first, const std::vector<Point2>& second) {
  double farthest = 0;
  for (const Point2 p : first) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point2 q : second) nearest = std::min(nearest, distance(p, q));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

std::vector<Point2> pointsOf(const std::vector<std::optional<Point2>>& places) {
  std::vector<Point2> points;
  for (const auto& place : places)
    if (place) points.push_back(*place);
  return points;
}

/// Corners of a zone that is a convex polygon.
std::vector<Point2> zoneCorners(const RuleDefinition& rule, const AF2Binding& binding) {
  const auto made = rule.zone->makeFreeZone(binding);
  const auto* polygon = dynamic_cast<const ConvexPolygonZone*>(made.zone.get());
  if (!polygon) return {};
  return {polygon->corners().begin(), polygon->corners().end()};
}

std::string byUpTo(const char* what, double size) {
  char text[80];
  std::snprintf(text, sizeof text, "%s by up to %.2g", what, size);
  return text;
}

/// What differs of two rules whose vertices lie at the same places.
std::string otherDifferences(const RuleDefinition& a, const RuleDefinition& b,
                             const Renumbering& to) {
  bool differConditions = false, differCosts = false, differZones = false;
  for (std::size_t sample = 0; sample < 4; ++sample) {
    const RuleAtMatch here(a, matchOf(a, a.firstLevel, sample), a.firstLevel),
        there(b, renumbered(here.vertices(), to), a.firstLevel);
    differConditions |= failedRequirement(a, here.binding()).isNone() !=
                        failedRequirement(b, there.binding()).isNone();
    differCosts |= !haveSameCosts(a, b, here.binding(), there.binding());
    differZones |= !haveSameZones(a, b, here.binding(), there.binding());
  }
  Renumbering all = to;
  std::string text;
  const auto add = [&](bool differs, const char* part) {
    if (differs) text += (text.empty() ? "" : ", ") + std::string(part);
  };
  add(differConditions, "conditions");
  add(differCosts, "costs");
  add(matchNewVertices(a, b, all) && elementsOf(a, all) != elementsOf(b, {}), "elements");
  add(differZones, "zones");
  return text.empty() ? "conditions, costs, elements or zones" : text;
}

}  // namespace

std::string differenceOf(const RuleDefinition& a, const RuleDefinition& b) {
  const auto to = matchVertices(a, b);
  if (!to) return {};
  double vertices = 0, zones = 0;
  for (std::size_t sample = 0; sample < 20; ++sample) {
    const RuleAtMatch here(a, matchOf(a, a.firstLevel, sample), a.firstLevel),
        there(b, renumbered(here.vertices(), *to), a.firstLevel);
    vertices = std::max(vertices, distanceOf(pointsOf(newVerticesAt(a, here.binding())),
                                             pointsOf(newVerticesAt(b, there.binding()))));
    const auto cornersA = zoneCorners(a, here.binding()),
               cornersB = zoneCorners(b, there.binding());
    if (cornersA.empty() || cornersB.empty()) continue;
    zones = std::max({zones, distanceOf(cornersA, cornersB), distanceOf(cornersB, cornersA)});
  }
  std::vector<std::string> parts;
  if (a.firstLevel != b.firstLevel || a.lastLevel != b.lastLevel) parts.push_back("levels");
  if (!haveSameTolerances(a, b, *to)) parts.push_back("tolerances");
  if (vertices > kSame) parts.push_back(byUpTo("new vertices", vertices));
  if (zones > kSame) parts.push_back(byUpTo("free zones", zones));
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? otherDifferences(a, b, *to) : text;
}

bool alwaysTie(const RuleDefinition& a, const RuleDefinition& b,
               const RuleSetDefinition& settings) {
  constexpr std::size_t kSamples = 12;
  const auto to = matchVertices(a, b);
  if (!to || !settings.metric || !haveSameEdges(a, b, *to) || !haveSameTolerances(a, b, *to))
    return false;
  if (a.firstLevel != b.firstLevel || a.lastLevel != b.lastLevel || a.priority != b.priority)
    return false;
  for (std::size_t sample = 0; sample < kSamples; ++sample)
    for (const int level : {a.firstLevel, a.firstLevel + 2}) {
      const RuleAtMatch here(a, matchOf(a, level, sample), level),
          there(b, renumbered(here.vertices(), *to), level);
      if (failedRequirement(a, here.binding()).isNone() !=
              failedRequirement(b, there.binding()).isNone() ||
          !haveSameCosts(a, b, here.binding(), there.binding()) ||
          !haveSameZones(a, b, here.binding(), there.binding()) ||
          !haveSameScores(here, a.elements, there, b.elements, settings))
        return false;
    }
  return true;
}

bool areAlike(const RuleDefinition& a, const RuleDefinition& b) {
  const auto to = matchVertices(a, b);
  return to && haveSameEdges(a, b, *to) && a.elements.size() == b.elements.size();
}

bool doTheSame(const RuleDefinition& a, const RuleDefinition& b) {
  auto to = matchVertices(a, b);
  if (!to || !haveSameEdges(a, b, *to) || !haveSameTolerances(a, b, *to)) return false;
  if (a.firstLevel != b.firstLevel || a.lastLevel != b.lastLevel) return false;
  if (!matchNewVertices(a, b, *to)) return false;
  return elementsOf(a, *to) == elementsOf(b, {}) && agreeAtMatches(a, b, *to);
}

}  // namespace af2::dsl
