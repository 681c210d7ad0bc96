#include "engine/rule/rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/base/error.h"
#include "tests/support/triangle_rules.h"

namespace af2 {
namespace {

using namespace af2::testing;
using Edges = std::vector<std::pair<int, int>>;
using Walk = std::vector<int>;

Edges sorted(const std::vector<PatternEdge>& edges) {
  Edges result;
  for (const PatternEdge& e : edges) result.emplace_back(e.from, e.to);
  std::sort(result.begin(), result.end());
  return result;
}

struct Derived {
  AF2Rule rule;
  Edges consumed, added;
  Walk replacement;
};

/// What follows from each classical rule, worked out by hand.
std::vector<Derived> derivedFromClassicalRules() {
  return {
      {freeTriangle(), {{0, 1}}, {{0, 2}, {2, 1}}, {2}},
      {flatTriangle(5, .5, .7), {{0, 1}}, {{0, 2}, {2, 1}}, {2}},
      {flatTriangle(10, .3, .5), {{0, 1}}, {{0, 2}, {2, 1}}, {2}},
      {flatTriangle(20, .1, .2), {{0, 1}}, {{0, 2}, {2, 1}}, {2}},
      {right60(), {{0, 1}, {1, 2}}, {{0, 2}}, {2}},
      {left60(), {{0, 1}, {2, 0}}, {{2, 1}}, {2}},
      {right120(), {{0, 1}, {1, 2}}, {{0, 3}, {3, 2}}, {3, 2}},
      {left120(), {{0, 1}, {2, 0}}, {{2, 3}, {3, 1}}, {2, 3}},
      {leftRight120(), {{0, 1}, {1, 3}, {2, 0}}, {{2, 4}, {4, 3}}, {2, 4, 3}},
      {fillTriangle(), {{0, 1}, {1, 2}, {2, 0}}, {}, {2}},
      {visAVis(), {{0, 1}}, {{0, 2}, {2, 1}}, {2}},
      {twoHeightsVisAVis(), {{0, 1}, {2, 3}}, {{0, 4}, {2, 4}, {4, 1}, {4, 3}}, {4, 3, 2, 4}},
  };
}

TEST(Rule, DerivesTheEdgesThatAClassicalRuleConsumes) {
  for (const Derived& d : derivedFromClassicalRules())
    EXPECT_EQ(sorted(d.rule.consumedEdges()), d.consumed) << d.rule.name();
}

TEST(Rule, DerivesTheEdgesThatAClassicalRuleAdds) {
  for (const Derived& d : derivedFromClassicalRules())
    EXPECT_EQ(sorted(d.rule.newEdges()), d.added) << d.rule.name();
}

TEST(Rule, DerivesTheWalkThatTakesThePlaceOfTheBase) {
  for (const Derived& d : derivedFromClassicalRules())
    EXPECT_EQ(Walk(d.rule.replacement().begin(), d.rule.replacement().end()), d.replacement)
        << d.rule.name();
}

TEST(Rule, CountsItsVertices) {
  const AF2Rule rule = leftRight120();
  EXPECT_EQ(rule.matchedCount(), 4);
  EXPECT_EQ(rule.newCount(), 1);
  EXPECT_EQ(rule.vertexCount(), 5);
}

TEST(Rule, AppliesFromItsFirstLevelOn) {
  const AF2Rule rule = flatTriangle(5, .5, .7);
  EXPECT_FALSE(rule.appliesAt(4));
  EXPECT_TRUE(rule.appliesAt(5));
  EXPECT_TRUE(rule.appliesAt(1000));
}

TEST(Rule, AppliesUpToItsLastLevelIfItHasOne) {
  RuleDefinition definition = freeTriangle().definition();
  definition.firstLevel = 2;
  definition.lastLevel = 3;
  const AF2Rule rule(definition);
  EXPECT_FALSE(rule.appliesAt(1));
  EXPECT_TRUE(rule.appliesAt(2));
  EXPECT_TRUE(rule.appliesAt(3));
  EXPECT_FALSE(rule.appliesAt(4));
}

TEST(Rule, TakesAQuadrilateralAndAnEdgeThatIsMatchedButKept) {
  RuleDefinition definition =
      ruleWith("quad", 1, {{"c", {1, 1}}, {"d", {0, 1}}, {"e", {2, 1}}}, {{0, 1}, {1, 2}, {2, 4}});
  definition.zone = zone({at(0), at(1), at(2), at(3)});
  definition.elements = {{{0, 1, 2, 3}}};
  const AF2Rule rule(definition);
  EXPECT_EQ(sorted(rule.consumedEdges()), (Edges{{0, 1}, {1, 2}}));
  EXPECT_EQ(sorted(rule.newEdges()), (Edges{{0, 3}, {3, 2}}));
}

// ---- rejections --------------------------------------------------------------------------------

std::string errorOf(const RuleDefinition& definition) {
  try {
    AF2Rule rule(definition);
    return "no error";
  } catch (const InputError& e) {
    return e.what();
  }
}

RuleDefinition right120Definition() { return right120().definition(); }

TEST(RuleRejection, OfTooFewVertices) {
  RuleDefinition d = right120Definition();
  d.vertices.resize(1);
  EXPECT_EQ(errorOf(d), "rule \"right 120\": needs the ends a, b of the base edge");
}

TEST(RuleRejection, OfTooManyVertices) {
  RuleDefinition d = right120Definition();
  while (d.vertices.size() < 12) d.vertices.push_back({"v", {3, 3}});
  EXPECT_EQ(errorOf(d), "rule \"right 120\": has 13 vertices; at most 12 are possible");
}

TEST(RuleRejection, OfANewVertexWithoutAPosition) {
  RuleDefinition d = right120Definition();
  d.newVertices = {nullptr};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": a new vertex has no position");
}

TEST(RuleRejection, OfAMissingZone) {
  RuleDefinition d = right120Definition();
  d.zone = nullptr;
  EXPECT_EQ(errorOf(d), "rule \"right 120\": has no free zone");
}

TEST(RuleRejection, OfEmptyLevels) {
  RuleDefinition d = right120Definition();
  d.firstLevel = 0;
  EXPECT_EQ(errorOf(d), "rule \"right 120\": its quality levels are empty");
  d.firstLevel = 5;
  d.lastLevel = 4;
  EXPECT_EQ(errorOf(d), "rule \"right 120\": its quality levels are empty");
}

TEST(RuleRejection, OfAPatternThatDoesNotBeginWithTheBase) {
  RuleDefinition d = right120Definition();
  d.edges = {};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": the first pattern edge must be the base a->b");
  d.edges = {{1, 2}, {0, 1}};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": the first pattern edge must be the base a->b");
}

TEST(RuleRejection, OfAPatternEdgeToAVertexThatIsNotMatched) {
  RuleDefinition d = right120Definition();
  d.edges = {{0, 1}, {1, 3}};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": a pattern edge uses a vertex that is not matched");
  d.edges = {{0, 1}, {1, -1}};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": a pattern edge uses a vertex that is not matched");
}

TEST(RuleRejection, OfAPatternEdgeFromAVertexToItself) {
  RuleDefinition d = right120Definition();
  d.edges = {{0, 1}, {2, 2}};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": a pattern edge begins and ends at the same vertex");
}

TEST(RuleRejection, OfChainsThatBranch) {
  RuleDefinition d = leftRight120().definition();
  d.edges = {{0, 1}, {1, 2}, {1, 3}};
  EXPECT_EQ(errorOf(d), "rule \"left right 120\": the chains of the pattern branch at b->d");
  d.edges = {{0, 1}, {2, 0}, {3, 0}};
  EXPECT_EQ(errorOf(d), "rule \"left right 120\": the chains of the pattern branch at d->a");
}

TEST(RuleRejection, OfNoElements) {
  RuleDefinition d = right120Definition();
  d.elements = {};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": makes no element");
}

TEST(RuleRejection, OfTooManyElements) {
  RuleDefinition d = right120Definition();
  d.elements.resize(9, d.elements[0]);
  EXPECT_EQ(errorOf(d), "rule \"right 120\": makes more than 8 elements");
}

TEST(RuleRejection, OfAnElementWithAnUnknownVertex) {
  RuleDefinition d = right120Definition();
  d.elements[0] = {{0, 1, 4, -1}};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": an element uses an unknown vertex");
  d.elements[0] = {{0, -1, 3, -1}};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": an element uses an unknown vertex");
}

TEST(RuleRejection, OfAnElementThatRepeatsAVertex) {
  RuleDefinition d = right120Definition();
  d.elements[0] = {{0, 1, 1, -1}};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": an element repeats vertex b");
}

TEST(RuleRejection, OfAQuadrilateralThatRepeatsAVertexAcross) {
  RuleDefinition d = ruleWith("bow", 1, {{"c", {1, 1}}}, {{0, 1}});
  d.zone = zone({at(0), at(1), at(2)});
  d.elements = {{{0, 1, 2, 1}}};
  EXPECT_NE(errorOf(d), "no error");
}

TEST(RuleRejection, OfAnElementEdgeUsedTwiceInOneDirection) {
  RuleDefinition d = right120Definition();
  d.elements = {{{0, 1, 3, -1}}, {{0, 1, 2, -1}}};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": two elements use the edge a->b in the same direction");
}

TEST(RuleRejection, OfElementsThatDoNotConsumeTheBase) {
  RuleDefinition d = right120Definition();
  d.elements = {{{1, 2, 3, -1}}};
  EXPECT_EQ(errorOf(d), "rule \"right 120\": does not consume its base edge a->b");
}

TEST(RuleRejection, OfElementsOnTheWrongSideOfTheBase) {
  RuleDefinition d = right120Definition();
  d.elements = {{{1, 0, 3, -1}}};
  EXPECT_EQ(errorOf(d),
            "rule \"right 120\": its elements lie on the wrong side of the front edge a->b");
}

TEST(RuleRejection, OfElementsOnTheWrongSideOfAnotherPatternEdge) {
  RuleDefinition d = right120Definition();
  d.elements = {{{0, 1, 3, -1}}, {{2, 1, 3, -1}}};
  EXPECT_NE(errorOf(d), "no error");
}

TEST(RuleRejection, OfElementsApartFromTheBase) {
  RuleDefinition d = ruleWith("apart", 1, {{"c", {.5, 1}}, {"d", {3, 0}}, {"e", {4, 0}}}, {{0, 1}});
  d.newVertices = {combine({3.5, 1}, {})};
  d.newVertexNames = {"f"};
  d.zone = zone({at(0), at(1), at(2)});
  d.elements = {{{0, 1, 2, -1}}, {{3, 4, 5, -1}}};
  EXPECT_EQ(errorOf(d),
            "rule \"apart\": the boundary of its elements is not one closed walk through a->b");
}

TEST(RuleRejection, OfAnElementThatCoversTheWholeSphere) {
  // Two triangles back to back: no boundary is left.
  RuleDefinition d = ruleWith("pillow", 1, {{"c", {.5, 1}}}, {{0, 1}});
  d.zone = zone({at(0), at(1), at(2)});
  d.elements = {{{0, 1, 2, -1}}, {{1, 0, 2, -1}}};
  EXPECT_NE(errorOf(d), "no error");
}

TEST(RuleRejection, OfATransformThatNeedsMoreVerticesThanAreMatched) {
  RuleDefinition d = right120Definition();
  d.newVertices = {vertex(3)};
  EXPECT_NE(errorOf(d), "no error");
}

TEST(RuleRejection, OfNewVertexNamesThatDoNotFitTheNewVertices) {
  RuleDefinition d = right120Definition();
  d.newVertexNames = {"d", "e"};
  EXPECT_NE(errorOf(d), "no error");
}

TEST(RuleRejection, OfVerticesThatShareAName) {
  // The header promises that repeated vertices are told.
  RuleDefinition d = right120Definition();
  d.vertices[2].name = "b";
  EXPECT_NE(errorOf(d), "no error");
}

}  // namespace
}  // namespace af2
