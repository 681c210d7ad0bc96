// The classical triangle rules built through the C++ API, for tests of the engine without rule
// text.
#pragma once

#include <cmath>
#include <memory>

#include "engine/rule/rule_set.h"
#include "engine/step/single_step.h"

namespace af2::testing {

using Transform = std::shared_ptr<const AF2PointTransform>;

/// constant + sum of weight * vertex
inline Transform combine(Point2 constant, std::vector<std::pair<int, double>> weights) {
  std::vector<AffinePointTransform::Term> terms;
  for (const auto& [vertex, w] : weights) terms.push_back({vertex, w, 0, 0, w});
  return std::make_shared<AffinePointTransform>(constant, std::move(terms));
}
inline Transform vertex(int v) { return combine({0, 0}, {{v, 1}}); }
inline ConvexPolygonZoneDef::Corner at(int v) { return {vertex(v), nullptr}; }

inline std::vector<double> byLevel(int levels, double (*f)(double)) {
  std::vector<double> values;
  for (int q = 1; q <= levels; ++q) values.push_back(f(q));
  return values;
}

inline std::shared_ptr<const AF2FreeZoneDef> zone(
    std::vector<ConvexPolygonZoneDef::Corner> corners) {
  return std::make_shared<ConvexPolygonZoneDef>(std::move(corners),
                                                byLevel(50, [](double q) { return 1 / q; }));
}

inline RuleDefinition ruleWith(std::string name, int level, std::vector<PatternVertex> more,
                               std::vector<PatternEdge> edges) {
  RuleDefinition rule;
  rule.name = std::move(name);
  rule.firstLevel = level;
  rule.vertices = {{"a", {0, 0}}, {"b", {1, 0}}};
  for (auto& v : more) rule.vertices.push_back(std::move(v));
  rule.edges = std::move(edges);
  return rule;
}

inline AF2Rule freeTriangle() {
  RuleDefinition rule = ruleWith("free triangle 1", 1, {}, {{0, 1}});
  const Transform c = combine({0, 0.866}, {{0, .5}, {1, .5}});
  rule.newVertices = {c};
  rule.newVertexNames = {"c"};
  rule.zone = zone({at(0),
                    at(1),
                    {combine({1, .7}, {{0, .5}, {1, .5}}), c},
                    {combine({0, 1.5}, {{0, .5}, {1, .5}}), c},
                    {combine({-1, .7}, {{0, .5}, {1, .5}}), c}});
  rule.elements = {{{0, 1, 2, -1}}};
  return AF2Rule(rule);
}

inline AF2Rule flatTriangle(int level, double height, double zoneHeight) {
  RuleDefinition rule = ruleWith("free triangle " + std::to_string(level), level, {}, {{0, 1}});
  const Transform c = combine({0, height}, {{0, .5}, {1, .5}});
  rule.newVertices = {c};
  rule.newVertexNames = {"c"};
  rule.zone = zone({at(0),
                    at(1),
                    {combine({0, zoneHeight}, {{1, 1}}), c},
                    {combine({0, zoneHeight}, {{0, 1}}), c}});
  rule.elements = {{{0, 1, 2, -1}}};
  return AF2Rule(rule);
}

inline AF2Rule right60() {
  RuleDefinition rule =
      ruleWith("right 60", 1, {{"c", {0.5, 0.866}, ToleranceForm{.6, 0, .8}}}, {{0, 1}, {1, 2}});
  rule.zone =
      zone({at(0),
            at(1),
            at(2),
            {combine({}, {{1, -.5}, {0, .75}, {2, .75}}), combine({}, {{0, .5}, {2, .5}})}});
  rule.elements = {{{0, 1, 2, -1}}};
  return AF2Rule(rule);
}

inline AF2Rule left60() {
  RuleDefinition rule = ruleWith("left 60", 1, {{"c", {0.5, 0.866}}}, {{0, 1}, {2, 0}});
  rule.zone = zone({at(0),
                    at(1),
                    {combine({}, {{0, -.5}, {1, .75}, {2, .75}}), combine({}, {{1, .5}, {2, .5}})},
                    at(2)});
  rule.elements = {{{0, 1, 2, -1}}};
  return AF2Rule(rule);
}

inline AF2Rule right120() {
  RuleDefinition rule = ruleWith("right 120", 1, {{"c", {1.5, 0.866}}}, {{0, 1}, {1, 2}});
  rule.newVertices = {combine({}, {{0, 1}, {1, -1}, {2, 1}})};
  rule.newVertexNames = {"d"};
  rule.zone = zone({at(0),
                    at(1),
                    at(2),
                    {combine({}, {{0, 1}, {1, -2}, {2, 2}})},
                    {combine({}, {{0, 2}, {1, -3}, {2, 2}})},
                    {combine({}, {{0, 2}, {1, -2}, {2, 1}})}});
  rule.elements = {{{0, 1, 3, -1}}, {{1, 2, 3, -1}}};
  return AF2Rule(rule);
}

inline AF2Rule left120() {
  RuleDefinition rule = ruleWith("left 120", 1, {{"c", {-0.5, 0.866}}}, {{0, 1}, {2, 0}});
  rule.newVertices = {combine({}, {{0, -1}, {1, 1}, {2, 1}})};
  rule.newVertexNames = {"d"};
  rule.zone = zone({at(0),
                    at(1),
                    {combine({}, {{0, -2}, {1, 2}, {2, 1}})},
                    {combine({}, {{0, -3}, {1, 2}, {2, 2}})},
                    {combine({}, {{0, -2}, {1, 1}, {2, 2}})},
                    at(2)});
  rule.elements = {{{0, 1, 3, -1}}, {{0, 3, 2, -1}}};
  return AF2Rule(rule);
}

inline AF2Rule leftRight120() {
  RuleDefinition rule = ruleWith("left right 120", 1, {{"c", {-0.5, 0.866}}, {"d", {1.5, 0.866}}},
                                 {{0, 1}, {2, 0}, {1, 3}});
  rule.newVertices = {combine({}, {{2, .5}, {3, .5}})};
  rule.newVertexNames = {"e"};
  rule.zone = zone({at(0),
                    at(1),
                    at(3),
                    {combine({}, {{1, -.5}, {2, .375}, {3, 1.125}})},
                    {combine({}, {{0, -.5}, {2, 1.125}, {3, .375}})},
                    at(2)});
  rule.elements = {{{0, 1, 4, -1}}, {{2, 0, 4, -1}}, {{1, 3, 4, -1}}};
  return AF2Rule(rule);
}

inline AF2Rule fillTriangle() {
  RuleDefinition rule =
      ruleWith("fill triangle", 1, {{"c", {0.5, 0.866}}}, {{0, 1}, {1, 2}, {2, 0}});
  rule.zone = zone({at(0), at(1), at(2)});
  rule.elements = {{{0, 1, 2, -1}}};
  return AF2Rule(rule);
}

inline AF2Rule visAVis() {
  RuleDefinition rule = ruleWith("vis a vis", 1, {{"c", {0.5, 0.866}}}, {{0, 1}});
  rule.zone = zone({at(0),
                    at(1),
                    {combine({}, {{0, -.6}, {1, .8}, {2, .8}}), combine({}, {{1, .5}, {2, .5}})},
                    at(2),
                    {combine({}, {{1, -.6}, {0, .8}, {2, .8}}), combine({}, {{0, .5}, {2, .5}})}});
  rule.elements = {{{0, 1, 2, -1}}};
  return AF2Rule(rule);
}

inline AF2Rule twoHeightsVisAVis() {
  RuleDefinition rule =
      ruleWith("2 h vis a vis", 3, {{"c", {1, 1.732}}, {"d", {0, 1.732}}}, {{0, 1}, {2, 3}});
  rule.newVertices = {combine({}, {{0, .25}, {1, .25}, {2, .25}, {3, .25}})};
  rule.newVertexNames = {"e"};
  rule.zone = zone({at(0),
                    at(1),
                    {combine({}, {{0, -.25}, {3, -.25}, {1, .75}, {2, .75}})},
                    at(2),
                    at(3),
                    {combine({}, {{1, -.25}, {2, -.25}, {0, .75}, {3, .75}})}});
  rule.elements = {{{0, 1, 4, -1}}, {{2, 3, 4, -1}}};
  return AF2Rule(rule);
}

/// The definition of the whole set, for tests that change something in it.
inline RuleSetDefinition triangleSetDefinition() {
  RuleSetDefinition set;
  set.name = "triangles";
  set.maxLevel = 50;
  set.matchTolerance = byLevel(50, [](double q) { return 0.5 + 0.3 * q; });
  set.metric = std::make_shared<ShapeSizeMetric>(10);
  set.acceptance =
      std::make_shared<ScoreBound>(byLevel(50, [](double q) { return 2 + .5 * q * q; }));
  set.order = std::make_shared<LayeredFrontOrder>(1, 1, 1);
  set.rules = {freeTriangle(),
               flatTriangle(5, .5, .7),
               flatTriangle(10, .3, .5),
               flatTriangle(20, .1, .2),
               right60(),
               left60(),
               right120(),
               left120(),
               leftRight120(),
               fillTriangle(),
               visAVis(),
               twoHeightsVisAVis()};
  return set;
}

inline std::shared_ptr<const RuleSet> triangleSet() {
  return std::make_shared<RuleSet>(triangleSetDefinition());
}

/// Two edges, from (0, 0) to (1, 0) and on to `c`.
inline FrontPiece corner(Point2 c) { return {{{0, 0}, {1, 0}, c}, {{0, 1, 2}}, {}, {0, 1}}; }

}  // namespace af2::testing
