// Rules of the classical quad set whose faults are known, put together by hand.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/triangle_rules.h"

namespace af2::testing {

using Weights = std::vector<std::pair<int, double>>;

/// Vertices by number: 0 a, 1 b, 2 c, 3 d. Corners: preferred, limiting.
inline ConvexPolygonZoneDef::Corner corner(const Weights& preferred, const Weights& limiting) {
  return {combine({}, preferred), combine({}, limiting)};
}

inline RuleElement quad(int a, int b, int c, int d) {
  return {{static_cast<std::int8_t>(a), static_cast<std::int8_t>(b), static_cast<std::int8_t>(c),
           static_cast<std::int8_t>(d)}};
}

/// Nonzero if three matched vertices do not turn right.
class NotClockwise final : public AF2BindingFunction {
 public:
  NotClockwise(int p, int q, int r) : p_(p), q_(q), r_(r) {}
  std::optional<double> evaluate(const AF2Binding& binding) const override {
    const auto& v = binding.vertices;
    return cross(v[q_] - v[p_], v[r_] - v[p_]) >= 0;
  }

 private:
  int p_, q_, r_;
};

/// An isosceles trapezoid over the base, at very loose matches.
inline AF2Rule quadPRight150() {
  RuleDefinition rule = ruleWith("quad p right 150", 150, {{"c", {1, 1}}}, {{0, 1}});
  rule.newVertexNames = {"d"};
  // x = x2 - x3, y = y3: not a combination that moves with the frame.
  const auto mirrored = std::make_shared<AffinePointTransform>(
      Point2{}, std::vector<AffinePointTransform::Term>{{1, 1, 0, 0, 0}, {2, -1, 0, 0, 1}});
  rule.newVertices = {mirrored};
  rule.zone = std::make_shared<ConvexPolygonZoneDef>(
      std::vector<ConvexPolygonZoneDef::Corner>{at(0),
                                                at(1),
                                                corner({{1, .7}, {2, .5}}, {{1, .5}, {2, .5}}),
                                                at(2),
                                                {combine({}, {{1, -2}, {2, 1.5}}), mirrored}},
      byLevel(200, [](double q) { return 1 / q; }));
  rule.elements = {quad(0, 1, 2, 3)};
  rule.requirements = {std::make_shared<NotClockwise>(0, 1, 2)};
  return AF2Rule(rule);
}

inline AF2Rule twoRight() {
  RuleDefinition rule =
      ruleWith("two right", 1, {{"c", {1, 1}}, {"d", {0, 1}}}, {{0, 1}, {1, 2}, {2, 3}});
  rule.zone = zone({at(0), at(1), at(2), at(3),
                    corner({{1, -.25}, {2, -.25}, {3, .75}, {0, .75}}, {{3, .5}, {0, .5}})});
  rule.elements = {quad(0, 1, 2, 3)};
  return AF2Rule(rule);
}

inline AF2Rule leftRight() {
  RuleDefinition rule =
      ruleWith("left right", 1, {{"c", {1, 1}}, {"d", {0, 1}}}, {{0, 1}, {1, 2}, {3, 0}});
  rule.zone = zone({at(0), at(1), at(2),
                    corner({{1, -.25}, {0, -.25}, {2, .75}, {3, .75}}, {{2, .5}, {3, .5}}), at(3)});
  rule.elements = {quad(0, 1, 2, 3)};
  return AF2Rule(rule);
}

inline AF2Rule quadRight60() {
  RuleDefinition rule = ruleWith("quad right 60", 10,
                                 {{"c", {0.5, 0.866}, ToleranceForm{.6, 0, .8}}}, {{0, 1}, {1, 2}});
  rule.zone =
      zone({at(0), at(1), at(2), corner({{1, -.5}, {2, .75}, {0, .75}}, {{2, .5}, {0, .5}})});
  rule.elements = {{{0, 1, 2, -1}}};
  return AF2Rule(rule);
}

inline AF2Rule fillQuad() {
  RuleDefinition rule =
      ruleWith("fill quad", 1, {{"c", {1, 1}}, {"d", {0, 1}}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  rule.zone = zone({at(0), at(1), at(2), at(3)});
  rule.elements = {quad(0, 1, 2, 3)};
  return AF2Rule(rule);
}

inline RuleSet quadSet() {
  RuleSetDefinition set = triangleSetDefinition();
  set.name = "quads";
  set.maxLevel = 200;
  set.matchTolerance = byLevel(200, [](double q) { return 0.5 + 0.3 * q; });
  set.acceptance =
      std::make_shared<ScoreBound>(byLevel(200, [](double q) { return 2 + .5 * q * q; }));
  set.rules = {quadPRight150(), twoRight(), leftRight(), quadRight60(), fillQuad()};
  return RuleSet(set);
}

}  // namespace af2::testing
