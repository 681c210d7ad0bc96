#include "engine/step/compiled_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <thread>

#include "engine/base/error.h"
#include "tests/support/triangle_rules.h"

namespace af2 {
namespace {

using namespace af2::testing;
using Points = std::vector<Point2>;

const AF2Surroundings kNothingAround;

/// Deviations of the size that matches have; the base from short to long.
Points randomMatch(const AF2Rule& rule, std::mt19937& random) {
  std::uniform_real_distribution<double> deviation(-.6, .6), length(.3, 3);
  Points matched{{0, 0}, {length(random), 0}};
  for (std::size_t i = 2; i < rule.definition().vertices.size(); ++i)
    matched.push_back(rule.definition().vertices[i].reference.at(1) +
                      Point2{deviation(random), deviation(random)});
  return matched;
}

void expectSame(Point2 fast, Point2 open, const std::string& what) {
  EXPECT_NEAR(fast.x, open.x, 1e-13) << what;
  EXPECT_NEAR(fast.y, open.y, 1e-13) << what;
}

void expectFastFormsAgree(const RuleSet& set, std::mt19937& random, int matches) {
  const CompiledRules compiled(set);
  for (const CompiledRule& rule : compiled.rules()) {
    const RuleDefinition& definition = rule.rule->definition();
    const auto& def = dynamic_cast<const ConvexPolygonZoneDef&>(*definition.zone);
    ASSERT_TRUE(rule.newPoints) << definition.name;
    ASSERT_TRUE(rule.zone) << definition.name;
    for (int n = 0; n < matches; ++n) {
      const Points matched = randomMatch(*rule.rule, random);
      double x[AffineBatch::kCapacity], y[AffineBatch::kCapacity];
      rule.newPoints->evaluate(matched.data(), x, y);
      for (int k = 0; k < rule.newCount; ++k) {
        const auto& transform = definition.newVertices[static_cast<std::size_t>(k)];
        expectSame({x[k], y[k]}, *transform->transformPoint({matched, 1, &kNothingAround}),
                   definition.name + ", new vertex");
      }
      for (int level = 1; level <= 50; ++level) {
        const AF2Binding binding{matched, level, &kNothingAround};
        const double t = def.fade(level);
        rule.zone->at(level).evaluate(matched.data(), x, y);
        ASSERT_EQ(rule.zone->at(level).count, static_cast<int>(def.corners().size()));
        for (std::size_t k = 0; k < def.corners().size(); ++k) {
          const auto& corner = def.corners()[k];
          Point2 expected = *corner.preferred->transformPoint(binding);
          if (corner.limiting)
            expected = t * expected + (1 - t) * *corner.limiting->transformPoint(binding);
          expectSame({x[k], y[k]}, expected,
                     definition.name + ", corner " + std::to_string(k) + " at level " +
                         std::to_string(level));
        }
      }
    }
  }
}

TEST(CompiledRules, FastFormsOfTheClassicalRulesAgreeWithTheOpenForms) {
  std::mt19937 random(1);
  expectFastFormsAgree(*triangleSet(), random, 100);
}

TEST(CompiledRules, FastFormsOfRandomAffineTransformsAgreeWithTheOpenForms) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-2, 2);
  const auto transform = [&](int vertices) -> Transform {
    std::vector<AffinePointTransform::Term> terms;
    for (int v = 0; v < vertices; ++v)
      if (random() % 4 > 0)
        terms.push_back({v, number(random), number(random), number(random), number(random)});
    return std::make_shared<AffinePointTransform>(Point2{number(random), number(random)}, terms);
  };
  for (int round = 0; round < 30; ++round) {
    RuleDefinition rule = leftRight120().definition();
    rule.name = "random " + std::to_string(round);
    rule.newVertices = {transform(4)};
    std::vector<ConvexPolygonZoneDef::Corner> corners;
    for (std::size_t k = 0, count = 3 + random() % 6; k < count; ++k)
      corners.push_back({transform(4), random() % 2 ? transform(4) : nullptr});
    rule.zone = zone(corners);
    RuleSetDefinition set = triangleSetDefinition();
    set.rules = {AF2Rule(rule)};
    expectFastFormsAgree(RuleSet(set), random, 10);
  }
}

TEST(CompiledRules, KeepCornersThatAreMatchedVerticesToTheLastBit) {
  const auto set = triangleSet();
  const CompiledRules compiled(*set);
  std::mt19937 random(3);
  for (const CompiledRule& rule : compiled.rules()) {
    const auto& def = dynamic_cast<const ConvexPolygonZoneDef&>(*rule.rule->definition().zone);
    const Points matched = randomMatch(*rule.rule, random);
    double x[AffineBatch::kCapacity], y[AffineBatch::kCapacity];
    rule.zone->at(7).evaluate(matched.data(), x, y);
    for (std::size_t k = 0; k < def.corners().size(); ++k) {
      if (def.corners()[k].limiting) continue;
      const auto& affine = dynamic_cast<const AffinePointTransform&>(*def.corners()[k].preferred);
      const bool isVertex = affine.terms().size() == 1 && affine.constant() == Point2{};
      if (!isVertex) continue;
      EXPECT_EQ((Point2{x[k], y[k]}), matched[static_cast<std::size_t>(affine.terms()[0].vertex)]);
    }
  }
}

class UserTransform final : public AF2PointTransform {
  std::optional<Point2> transformPoint(const AF2Binding&) const override { return Point2{.5, 1}; }
};
class UserZone final : public AF2FreeZoneDef {
  Made makeFreeZone(const AF2Binding&) const override { return {nullptr, Refusal::Shape}; }
};

RuleSet setOf(RuleDefinition rule) {
  RuleSetDefinition set = triangleSetDefinition();
  set.rules = {AF2Rule(std::move(rule))};
  return RuleSet(set);
}

TEST(CompiledRules, UseTheOpenFormsOfAUser) {
  RuleDefinition rule = freeTriangle().definition();
  rule.newVertices = {std::make_shared<UserTransform>()};
  rule.zone = std::make_shared<UserZone>();
  const RuleSet set = setOf(rule);
  const CompiledRules compiled(set);
  EXPECT_FALSE(compiled.rules()[0].newPoints);
  EXPECT_FALSE(compiled.rules()[0].zone);
}

TEST(CompiledRules, UseTheOpenFormOfAZoneWithAUsersCorner) {
  RuleDefinition rule = freeTriangle().definition();
  rule.zone = zone({at(0), at(1), {std::make_shared<UserTransform>()}});
  const RuleSet set = setOf(rule);
  EXPECT_FALSE(CompiledRules(set).rules()[0].zone);
}

TEST(CompiledRules, UseTheOpenFormOfAZoneWithManyCorners) {
  RuleDefinition rule = freeTriangle().definition();
  std::vector<ConvexPolygonZoneDef::Corner> corners{at(0), at(1)};
  for (int k = 0; k < 8; ++k)
    corners.push_back({combine({std::cos(.3 * k), 1 + std::sin(.3 * k)}, {}), nullptr});
  rule.zone = zone(corners);
  const RuleSet set = setOf(rule);
  EXPECT_FALSE(CompiledRules(set).rules()[0].zone);
}

// ---- binding steps -----------------------------------------------------------------------------

using Kind = BindingStep::Kind;
struct Step {
  Kind kind;
  int vertex, from;
  bool operator==(const Step&) const = default;
};

std::vector<Step> stepsOf(const AF2Rule& rule) {
  const RuleSet set = setOf(rule.definition());
  const CompiledRules compiled(set);
  std::vector<Step> steps;
  for (const BindingStep& s : compiled.rules()[0].patternAt(1).steps)
    steps.push_back({s.kind, s.vertex, s.from});
  return steps;
}

TEST(CompiledRules, FollowTheChainsThroughTheBase) {
  EXPECT_EQ(stepsOf(freeTriangle()), std::vector<Step>{});
  EXPECT_EQ(stepsOf(right60()), (std::vector<Step>{{Kind::Next, 2, 1}}));
  EXPECT_EQ(stepsOf(left60()), (std::vector<Step>{{Kind::Previous, 2, 0}}));
  EXPECT_EQ(stepsOf(leftRight120()),
            (std::vector<Step>{{Kind::Next, 3, 1}, {Kind::Previous, 2, 0}}));
}

TEST(CompiledRules, CloseALoop) {
  EXPECT_EQ(stepsOf(fillTriangle()), (std::vector<Step>{{Kind::Next, 2, 1}, {Kind::Closes, 0, 2}}));
}

TEST(CompiledRules, SearchForVerticesAndChainsApartFromTheBase) {
  EXPECT_EQ(stepsOf(visAVis()), (std::vector<Step>{{Kind::Any, 2, -1}}));
  EXPECT_EQ(stepsOf(twoHeightsVisAVis()),
            (std::vector<Step>{{Kind::Any, 2, -1}, {Kind::Next, 3, 2}}));
}

TEST(CompiledRules, RejectAVertexApartFromTheBaseThatMayBeAnywhere) {
  RuleDefinition rule = visAVis().definition();
  rule.vertices[2].tolerance.reset();
  const RuleSet set = setOf(rule);
  EXPECT_THROW(CompiledRules{set}, InputError);
}

TEST(CompiledRules, LookForAVertexWhereItsLevelExpectsIt) {
  RuleDefinition rule = visAVis().definition();
  rule.vertices[2].reference =
      ReferenceByLevel(std::vector<Point2>{{.5, .9}, {.5, .9}, {3, .7}, {3, .7}});
  EXPECT_EQ(rule.vertices[2].reference.levelCount(), 3);
  const RuleSet set = setOf(rule);
  const CompiledRules compiled(set);
  ASSERT_EQ(compiled.rules()[0].patterns.size(), 3u);
  const auto reference = [&](int level) {
    return compiled.rules()[0].patternAt(level).steps[0].reference;
  };
  EXPECT_EQ(reference(1), (Point2{.5, .9}));
  EXPECT_EQ(reference(2), (Point2{.5, .9}));
  EXPECT_EQ(reference(3), (Point2{3, .7}));
  EXPECT_EQ(reference(9), (Point2{3, .7}));
  const Window there{3, .7, 3.5, .7};
  EXPECT_FALSE(compiled.windowAt(2, 1, true).contains(there));
  EXPECT_TRUE(compiled.windowAt(3, 1, true).contains(there));
}

TEST(CompiledRules, HaveOnePatternWhereNothingGoesByTheLevel) {
  const auto set = triangleSet();
  const CompiledRules compiled(*set);
  for (const CompiledRule& rule : compiled.rules()) EXPECT_EQ(rule.patterns.size(), 1u);
}

// ---- windows -----------------------------------------------------------------------------------

TEST(CompiledRules, WindowHoldsEveryPlaceThatAFreeVertexCanMatch) {
  const auto set = triangleSet();
  const CompiledRules compiled(*set);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int level : {1, 2, 5, 10, 50}) {
    const double tolerance = set->matchTolerance(level), reach = std::sqrt(tolerance);
    for (double base : {.2, 1.0, 3.9, 7.0}) {
      const Window window = compiled.windowAt(level, base, false);
      for (const CompiledRule& rule : compiled.rules()) {
        if (level < rule.firstLevel) continue;
        for (const BindingStep& step : rule.patternAt(level).steps) {
          if (step.kind != Kind::Any) continue;
          const PatternVertex& v =
              rule.rule->definition().vertices[static_cast<std::size_t>(step.vertex)];
          for (int n = 0; n < 200; ++n) {
            const Point2 d{reach * number(random), reach * number(random)};
            if (v.tolerance->at(level)(d) > tolerance) continue;
            const Point2 p = v.reference.at(level) + d;
            EXPECT_TRUE(window.contains({p.x, p.y, p.x, p.y}));
          }
        }
      }
    }
  }
}

TEST(CompiledRules, WindowGrowsWithTheLevelAndTheBase) {
  const auto set = triangleSet();
  const CompiledRules compiled(*set);
  for (int level = 1; level < 50; ++level)
    EXPECT_TRUE(compiled.windowAt(level + 1, 1, true).contains(compiled.windowAt(level, 1, true)) ||
                level < 5)
        << level;
  for (double base : {.1, 1.0, 5.0, 100.0}) {
    const Window window = compiled.windowAt(1, base, true);
    EXPECT_TRUE(window.contains({0, 0, base, 0})) << base;
  }
}

/// Windows are made when they are first asked for.
TEST(CompiledRules, WindowsAreTheSameWhicheverThreadAsksFirst) {
  const auto set = triangleSet();
  const CompiledRules alone(*set), shared(*set);
  std::vector<std::jthread> threads;
  for (int first = 1; first <= 4; ++first)
    threads.emplace_back([&, first] {
      for (int step = 0; step < 50; ++step) {
        const int level = 1 + (step * 7 + first) % 50;
        const Window window = shared.windowAt(level, 1.3, false);
        EXPECT_TRUE(window.contains({0, 0, 1.3, 0}));
      }
    });
  threads.clear();
  for (int level = 1; level <= 50; ++level)
    for (const bool withWide : {false, true}) {
      const Window one = alone.windowAt(level, 1.3, withWide);
      const Window other = shared.windowAt(level, 1.3, withWide);
      EXPECT_TRUE(one.contains(other) && other.contains(one)) << level;
    }
}

/// The free triangle with a zone that reaches up to a height.
RuleDefinition withZoneUpTo(double height) {
  RuleDefinition rule = freeTriangle().definition();
  const auto at = [](Point2 p) {
    return std::make_shared<AffinePointTransform>(p, std::vector<AffinePointTransform::Term>{});
  };
  rule.zone = std::make_shared<ConvexPolygonZoneDef>(
      std::vector<ConvexPolygonZoneDef::Corner>{
          {at({0, 0})}, {at({1, 0})}, {at({1, height})}, {at({0, height})}},
      std::vector<double>{1});
  return rule;
}

TEST(CompiledRules, ZonesThatReachFarAreLeftToTheirRules) {
  const RuleSet far = setOf(withZoneUpTo(2.1)), near = setOf(withZoneUpTo(1.9));
  const CompiledRules wide(far), ordinary(near);
  EXPECT_TRUE(wide.rules()[0].isWide);
  EXPECT_FALSE(ordinary.rules()[0].isWide);
  EXPECT_FALSE(wide.windowAt(1, 1, false).contains(ordinary.windowAt(1, 1, false)));
  EXPECT_TRUE(wide.windowAt(1, 1, true).contains(ordinary.windowAt(1, 1, true)));
}

TEST(CompiledRules, AreOrdinaryHoweverManyElementsTheyMakeCloseBy) {
  RuleDefinition rule = freeTriangle().definition();
  for (std::int8_t v = 3; v < 7; ++v) {  // a fan around b
    rule.newVertices.push_back(rule.newVertices[0]);
    rule.newVertexNames.push_back(std::string(1, static_cast<char>('a' + v)));
    rule.elements.push_back({{static_cast<std::int8_t>(v - 1), 1, v, -1}});
  }
  const RuleSet set = setOf(rule);
  EXPECT_FALSE(CompiledRules(set).rules()[0].isWide);
}

}  // namespace
}  // namespace af2
