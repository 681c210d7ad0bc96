// A few rules put together by hand, for tests that need rules and no rule files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dsl/shapes/shape.h"
#include "engine/rule/element_metric.h"
#include "engine/rule/front_order.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl::test {

struct Weighted {
  int vertex;
  double weight;
};

/// offset + sum of weight * vertex.
inline std::shared_ptr<const AF2PointTransform> sum(const std::vector<Weighted>& parts,
                                                    Point2 offset = {}) {
  std::vector<AffinePointTransform::Term> terms;
  for (const Weighted& part : parts) terms.push_back({part.vertex, part.weight, 0, 0, part.weight});
  return std::make_shared<AffinePointTransform>(offset, terms);
}

inline PatternVertex vertexAt(const std::string& name, Point2 reference) {
  PatternVertex vertex;
  vertex.name = name;
  vertex.reference = reference;
  return vertex;
}

inline RuleElement element(std::vector<int> corners) {
  RuleElement result;
  for (std::size_t i = 0; i < corners.size(); ++i)
    result.corners[i] = static_cast<std::int8_t>(corners[i]);
  return result;
}

using Corner = ConvexPolygonZoneDef::Corner;

inline std::vector<double> fadeOneByLevel() {
  std::vector<double> fade;
  for (int level = 1; level <= 50; ++level) fade.push_back(1.0 / level);
  return fade;
}

inline std::shared_ptr<const AF2FreeZoneDef> zone(std::vector<Corner> corners) {
  return std::make_shared<ConvexPolygonZoneDef>(std::move(corners), fadeOneByLevel());
}

inline RuleDefinition ruleOnBase(const std::string& name) {
  RuleDefinition rule;
  rule.name = name;
  rule.vertices = {vertexAt("a", {0, 0}), vertexAt("b", {1, 0})};
  rule.edges = {{0, 1}};
  rule.source = {"sample.af2", 12, false};
  return rule;
}

inline AF2Rule freeTriangle() {
  RuleDefinition rule = ruleOnBase("free triangle");
  const auto apex = sum({{0, 0.5}, {1, 0.5}}, {0, 0.866});
  rule.newVertexNames = {"c"};
  rule.newVertices = {apex};
  rule.zone = zone({{sum({{0, 1}}), nullptr},
                    {sum({{1, 1}}), nullptr},
                    {sum({{0, 0.5}, {1, 0.5}}, {1, 0.7}), apex},
                    {sum({{0, 0.5}, {1, 0.5}}, {0, 1.5}), apex},
                    {sum({{0, 0.5}, {1, 0.5}}, {-1, 0.7}), apex}});
  rule.elements = {element({0, 1, 2})};
  return AF2Rule(rule);
}

inline AF2Rule rightSixty() {
  RuleDefinition rule = ruleOnBase("right 60");
  rule.vertices.push_back(vertexAt("c", {0.5, 0.866}));
  rule.vertices[2].tolerance = ToleranceForm{0.6, 0, 0.8};
  rule.edges.push_back({1, 2});
  rule.zone = zone({{sum({{0, 1}}), nullptr},
                    {sum({{1, 1}}), nullptr},
                    {sum({{2, 1}}), nullptr},
                    {sum({{0, 0.75}, {2, 0.75}, {1, -0.5}}), sum({{0, 0.5}, {2, 0.5}})}});
  rule.elements = {element({0, 1, 2})};
  return AF2Rule(rule);
}

inline AF2Rule right120() {
  RuleDefinition rule = ruleOnBase("right 120");
  rule.vertices.push_back(vertexAt("c", {1.5, 0.866}));
  rule.edges.push_back({1, 2});
  rule.newVertexNames = {"d"};
  const std::vector<Weighted> d{{0, 1}, {1, -1}, {2, 1}};
  rule.newVertices = {sum(d)};
  rule.zone = zone({{sum({{0, 1}}), nullptr},
                    {sum({{1, 1}}), nullptr},
                    {sum({{2, 1}}), nullptr},
                    {sum({{0, 1}, {1, -2}, {2, 2}}), nullptr},
                    {sum({{0, 2}, {1, -3}, {2, 2}}), nullptr},
                    {sum({{0, 2}, {1, -2}, {2, 1}}), nullptr}});
  rule.elements = {element({0, 1, 3}), element({1, 2, 3})};
  return AF2Rule(rule);
}

inline AF2Rule visAVis() {
  RuleDefinition rule = ruleOnBase("vis a vis");
  rule.vertices.push_back(vertexAt("c", {0.5, 0.866}));
  rule.zone = zone({{sum({{0, 1}}), nullptr},
                    {sum({{1, 1}}), nullptr},
                    {sum({{0, -0.6}, {1, 0.8}, {2, 0.8}}), sum({{1, 0.5}, {2, 0.5}})},
                    {sum({{2, 1}}), nullptr},
                    {sum({{1, -0.6}, {0, 0.8}, {2, 0.8}}), sum({{0, 0.5}, {2, 0.5}})}});
  rule.elements = {element({0, 1, 2})};
  return AF2Rule(rule);
}

/// A zone of any shape, made from a function of the match.
class ShapeFunctionZoneDef final : public AF2FreeZoneDef {
 public:
  explicit ShapeFunctionZoneDef(Shape (*shape)(const AF2Binding&)) : shape_(shape) {}
  Made makeFreeZone(const AF2Binding& binding) const override {
    MadeZone made = makeZone(shape_(binding));
    return {std::move(made.zone), made.refusal};
  }

 private:
  Shape (*shape_)(const AF2Binding&);
};

/// A quad that closes a notch, with a disc in front that fades away.
inline AF2Rule tuck() {
  RuleDefinition rule = ruleOnBase("tuck");
  rule.vertices.push_back(vertexAt("c", {1, 1}));
  rule.vertices.push_back(vertexAt("d", {0, 1}));
  rule.edges.push_back({1, 2});
  rule.edges.push_back({3, 0});
  rule.zone = std::make_shared<ShapeFunctionZoneDef>([](const AF2Binding& match) {
    const auto& v = match.vertices;
    return Shape::poly({{v[0], {}}, {v[1], {}}, {v[2], {}}, {v[3], {}}}) |
           Shape::disc(0.5 * (v[2] + v[3]), 0.4 / match.level);
  });
  rule.elements = {element({0, 1, 2, 3})};
  return AF2Rule(rule);
}

/// A row of quads goes on around an arc: a zone with arcs.
inline AF2Rule row() {
  RuleDefinition rule = ruleOnBase("row");
  rule.firstLevel = 2;
  rule.lastLevel = 9;
  rule.vertices.push_back(vertexAt("d", {0, 1}));
  rule.vertices.push_back(vertexAt("e", {2, 0}));
  rule.vertices[3].tolerance.reset();
  rule.edges.push_back({2, 0});
  rule.edges.push_back({1, 3});
  rule.newVertexNames = {"c"};
  rule.newVertices = {sum({{1, 1}, {2, 1}, {0, -1}})};
  rule.zone = std::make_shared<ShapeFunctionZoneDef>([](const AF2Binding& match) {
    const auto& v = match.vertices;
    const double t = 1.0 / match.level;
    const Point2 c = v[1] + v[2] - v[0];
    const auto out = [&](double x, double y) { return c + Point2{t * x, t * y}; };
    return Shape::poly({{v[0], {}},
                        {v[1], {}},
                        {v[1] + Point2{0.9 * t, 0.1 * t}, {}},
                        {out(0, 0.9), out(0.7, 0.6)},
                        {v[2] + Point2{0, 0.6 * t}, {}},
                        {v[2], {}}});
  });
  rule.elements = {element({0, 1, 4, 2})};
  return AF2Rule(rule);
}

inline RuleSet sampleRules() {
  RuleSetDefinition set;
  set.name = "sample rules";
  for (int level = 1; level <= set.maxLevel; ++level)
    set.matchTolerance.push_back(0.5 + 0.3 * level);
  set.metric = std::make_shared<ShapeSizeMetric>(10);
  set.order = std::make_shared<LayeredFrontOrder>(1, 1, 1);
  set.rules = {freeTriangle(), rightSixty(), right120(), visAVis(), tuck(), row()};
  return RuleSet(set);
}

}  // namespace af2::dsl::test
