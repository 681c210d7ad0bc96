// The reference cases are those of MeshKit's tests of its default triangle rules
// (test/algs/AdvFront/dfltTriRules.cpp), in the coordinates of their chart: origin (-0.5, 0, 0.5),
// scale 0.125.
#include "engine/step/single_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/base/error.h"
#include "tests/support/triangle_rules.h"

namespace af2 {
namespace {

using namespace af2::testing;
using Points = std::vector<Point2>;
using Chains = std::vector<std::vector<std::size_t>>;
using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

// ---- reference cases ---------------------------------------------------------------------------

struct ReferenceCase {
  std::string name;
  AF2Rule rule;
  int level;
  Points vertices;
  Chains chains;
  std::pair<std::size_t, std::size_t> base;
  Points newVertices;
  std::size_t elements;
  /// Each: points that are added to the piece and hit the zone; two of them are joined by an edge.
  std::vector<Points> negatives;
};

std::vector<ReferenceCase> referenceCases() {
  return {
      {"line 178",
       freeTriangle(),
       1,
       {{-1, 0},
        {0, 0},
        {1, 0},
        {2, 0},
        {1.0016, 0},
        {1.5016, 0.7008},
        {0.5, 1.5016},
        {-0.5016, 0.7008},
        {-0.0016, 0}},
       {{0, 1, 2, 3}, {4, 5, 6, 7, 8}},
       {1, 2},
       {{0.5, 0.866}},
       1,
       {{{0.9984, 0.0008}},
        {{1.4984, 0.6992}},
        {{0.5, 1.4984}},
        {{-0.4984, 0.6992}},
        {{0.0016, 0.0008}}}},
      {"line 398",
       flatTriangle(10, .3, .5),
       10,
       {{-1, 0},
        {0, 0},
        {1, 0},
        {2, 0},
        {1.0016, 0},
        {0.5516, 0.3208},
        {0.4484, 0.3208},
        {-0.0016, 0}},
       {{0, 1, 2, 3}, {4, 5, 6, 7}},
       {1, 2},
       {{0.5, 0.3}},
       1,
       {{{0.9984, 0.0008}}, {{0.5484, 0.3192}}, {{0.4516, 0.3192}}, {{0.0016, 0.0008}}}},
      {"line 606",
       right60(),
       1,
       {{-1, 0},
        {0, 0},
        {1, 0},
        {0.5, 0.866},
        {1.5, 0.866},
        {0.5, 0.8676},
        {-0.1258, 0.6503},
        {-0.0016, 0}},
       {{0, 1, 2, 3, 4}, {5, 6, 7}},
       {1, 2},
       {},
       1,
       {{{0.5, 0.8644}}, {{-0.1242, 0.6487}}, {{0.0016, 0.0008}}}},
      {"line 792",
       right120(),
       1,
       {{-1, 0},
        {0, 0},
        {1, 0},
        {1.5, 0.866},
        {2.5, 0.866},
        {1.5008, 0.8668},
        {1, 1.7336},
        {0, 1.7336},
        {-0.5008, 0.8668},
        {-0.0016, 0}},
       {{0, 1, 2, 3, 4}, {5, 6, 7, 8, 9}},
       {1, 2},
       {{0.5, 0.866}},
       2,
       {{{1.4992, 0.8652}}, {{1, 1.7304}}, {{0, 1.7304}}, {{-0.4992, 0.8652}}, {{0.0016, 0.0008}}}},
      {"line 1034",
       leftRight120(),
       1,
       {{-1.5, 0.866},
        {-0.5, 0.866},
        {0, 0},
        {1, 0},
        {1.5, 0.866},
        {2.5, 0.866},
        {1.5008, 0.8668},
        {1, 1.3006},
        {0, 1.3006},
        {-0.5008, 0.8668}},
       {{0, 1, 2, 3, 4, 5}, {6, 7, 8, 9}},
       {2, 3},
       {{0.5, 0.866}},
       3,
       {{{1.4992, 0.8652}}, {{1, 1.2974}}, {{0, 1.2974}}, {{-0.4992, 0.8652}}}},
      {"line 1209",
       visAVis(),
       1,
       {{-1, 0},
        {0, 0},
        {1, 0},
        {2, 0},
        {0.5, 0.866},
        {1.0016, 0},
        {1.2008, 0.6938},
        {0.5, 0.8676},
        {-0.2008, 0.6938},
        {-0.0016, 0}},
       {{0, 1, 2, 3}, {5, 6, 7, 8, 9}},
       {1, 2},
       {},
       1,
       {{{0.9984, 0.0008}},
        {{1.1992, 0.6922}},
        {{-0.1992, 0.6922}},
        {{0.0016, 0.0008}},
        {{3, 0.8644}, {-3, 0.8644}}}},
  };
}

/// Only this rule, the reference's match window, every score accepted.
RuleSet setOfOne(const AF2Rule& rule) {
  RuleSetDefinition set = triangleSetDefinition();
  set.rules = {rule};
  set.acceptance = nullptr;
  set.matchTolerance = byLevel(50, [](double q) { return (.25 + .15 * q) * (.25 + .15 * q); });
  return RuleSet(set);
}

FrontPiece pieceOf(const ReferenceCase& c) {
  FrontPiece piece{c.vertices, c.chains, {}, c.base, c.level, 1};
  for (std::size_t v = 0; v < c.vertices.size(); ++v)
    if (std::none_of(c.chains.begin(), c.chains.end(), [&](const auto& chain) {
          return std::count(chain.begin(), chain.end(), v) > 0;
        }))
      piece.isolated.push_back(v);
  return piece;
}

TEST(SingleStep, AppliesEachRuleInItsReferenceCase) {
  for (const ReferenceCase& c : referenceCases()) {
    const SingleStep step = takeSingleStep(setOfOne(c.rule), pieceOf(c));
    ASSERT_TRUE(step.rule) << c.name;
    EXPECT_EQ(step.elements.size(), c.elements) << c.name;
    ASSERT_EQ(step.newVertices.size(), c.newVertices.size()) << c.name;
    for (std::size_t i = 0; i < c.newVertices.size(); ++i) {
      EXPECT_NEAR(step.newVertices[i].x, c.newVertices[i].x, 1e-14) << c.name;
      EXPECT_NEAR(step.newVertices[i].y, c.newVertices[i].y, 1e-14) << c.name;
    }
    EXPECT_TRUE(step.refusals.empty()) << c.name;
  }
}

TEST(SingleStep, RefusesEachRuleWhereItsZoneIsHitInTheReferenceCase) {
  for (const ReferenceCase& c : referenceCases()) {
    for (const Points& added : c.negatives) {
      FrontPiece piece = pieceOf(c);
      const std::size_t first = piece.vertices.size();
      piece.vertices.insert(piece.vertices.end(), added.begin(), added.end());
      if (added.size() == 1)
        piece.isolated.push_back(first);
      else
        piece.chains.push_back({first, first + 1});
      const SingleStep step = takeSingleStep(setOfOne(c.rule), piece);
      EXPECT_FALSE(step.rule) << c.name;
      ASSERT_EQ(step.refusals.size(), 1u) << c.name;
      const RuleRefusal& refusal = step.refusals[0];
      EXPECT_EQ(refusal.reason,
                added.size() == 1 ? Refusal::ZoneHitByVertex : Refusal::ZoneHitByEdge)
          << c.name << ", added (" << added[0].x << ", " << added[0].y
          << "): " << toString(refusal.reason);
      EXPECT_EQ(refusal.from, VertexId(first)) << c.name;
      EXPECT_EQ(refusal.to, added.size() == 1 ? VertexId() : VertexId(first + 1)) << c.name;
    }
  }
}

TEST(SingleStep, DoesNotDependOnPositionDirectionAndSize) {
  const Point2 x{.6, .8};
  for (const ReferenceCase& c : referenceCases()) {
    FrontPiece piece = pieceOf(c);
    piece.size = 8;
    for (Point2& p : piece.vertices)
      p = Point2{40, -16} + 8.0 * Point2{p.x * x.x - p.y * x.y, p.x * x.y + p.y * x.x};
    const SingleStep step = takeSingleStep(setOfOne(c.rule), piece);
    ASSERT_TRUE(step.rule) << c.name;
    for (std::size_t i = 0; i < c.newVertices.size(); ++i) {
      const Point2 p = c.newVertices[i];
      const Point2 expected =
          Point2{40, -16} + 8.0 * Point2{p.x * x.x - p.y * x.y, p.x * x.y + p.y * x.x};
      EXPECT_NEAR(distance(step.newVertices[i], expected), 0, 1e-12) << c.name;
    }
  }
}

// ---- what a step tells -------------------------------------------------------------------------

TEST(SingleStep, TellsWhatItMatchedAndMade) {
  const SingleStep step = takeSingleStep(setOfOne(right60()), corner({.5, .866}));
  ASSERT_TRUE(step.rule);
  EXPECT_EQ(*step.rule, 0u);
  EXPECT_EQ(step.matched, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(step.newVertices.empty());
  EXPECT_EQ(step.elements, (Chains{{0, 1, 2}}));
  EXPECT_EQ(step.frontAfter, (Edges{{0, 2}}));
  EXPECT_NEAR(step.score, 0, 1e-8);
}

TEST(SingleStep, NumbersNewVerticesOnBehindThoseOfThePiece) {
  const SingleStep step = takeSingleStep(setOfOne(right120()), corner({1.5, .866}));
  ASSERT_TRUE(step.rule);
  EXPECT_EQ(step.elements, (Chains{{0, 1, 3}, {1, 2, 3}}));
  EXPECT_EQ(step.frontAfter, (Edges{{0, 3}, {3, 2}}));
}

TEST(SingleStep, LeavesTheFrontAsItIsIfEveryRuleIsRefused) {
  const SingleStep step = takeSingleStep(setOfOne(right60()), corner({5, 5}));
  EXPECT_FALSE(step.rule);
  EXPECT_EQ(step.frontAfter, (Edges{{0, 1}, {1, 2}}));
}

TEST(SingleStep, ClosesALoop) {
  const FrontPiece piece{{{0, 0}, {1, 0}, {.5, .9}}, {{0, 1, 2, 0}}, {}, {0, 1}};
  const SingleStep step = takeSingleStep(setOfOne(fillTriangle()), piece);
  ASSERT_TRUE(step.rule);
  EXPECT_TRUE(step.frontAfter.empty());
}

TEST(SingleStep, GivesEveryRuleButTheAppliedOneAReason) {
  const auto set = triangleSet();
  const SingleStep step = takeSingleStep(*set, corner({.5, .866}));
  ASSERT_TRUE(step.rule);
  EXPECT_EQ(set->rules()[*step.rule].name(), "right 60");
  EXPECT_EQ(step.refusals.size(), 11u);
  for (const RuleRefusal& r : step.refusals) EXPECT_NE(r.reason, Refusal::None);
}

// ---- pieces that are no fronts -----------------------------------------------------------------

std::string errorOf(const FrontPiece& piece) {
  try {
    takeSingleStep(*triangleSet(), piece);
    return "no error";
  } catch (const InputError& e) {
    return e.what();
  }
}

TEST(PieceRejection, OfAVertexThatIsNotThere) {
  FrontPiece piece = corner({.5, .866});
  piece.chains[0].push_back(3);
  EXPECT_EQ(errorOf(piece), "piece of front: there is no vertex 3");
  piece = corner({.5, .866});
  piece.isolated = {7};
  EXPECT_EQ(errorOf(piece), "piece of front: there is no vertex 7");
}

TEST(PieceRejection, OfACoordinateThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(errorOf(corner({nan, 0})), "piece of front: vertex 2 is not at a finite position");
}

TEST(PieceRejection, OfAnEdgeOfLengthZero) {
  EXPECT_EQ(errorOf(corner({1, 0})), "piece of front: an edge has length zero");
}

TEST(PieceRejection, OfAnEdgeThatIsGivenTwice) {
  FrontPiece piece = corner({.5, .866});
  piece.chains.push_back({1, 2});
  EXPECT_EQ(errorOf(piece), "piece of front: an edge is given twice");
}

TEST(PieceRejection, OfABaseThatIsNoEdge) {
  FrontPiece piece = corner({.5, .866});
  piece.base = {1, 0};
  EXPECT_EQ(errorOf(piece), "piece of front: the base is not one of the edges");
}

TEST(PieceRejection, OfAChainOfOneVertex) {
  FrontPiece piece = corner({.5, .866});
  piece.chains.push_back({2});
  EXPECT_EQ(errorOf(piece), "piece of front: a chain has fewer than two vertices");
}

TEST(PieceRejection, OfALevelOrASizeOutOfRange) {
  for (int level : {0, 51}) {
    FrontPiece piece = corner({.5, .866});
    piece.level = level;
    EXPECT_EQ(errorOf(piece), "piece of front: the level must be between 1 and 50");
  }
  for (double size : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                      std::numeric_limits<double>::infinity()}) {
    FrontPiece piece = corner({.5, .866});
    piece.size = size;
    EXPECT_EQ(errorOf(piece), "piece of front: the size must be a positive number");
  }
}

}  // namespace
}  // namespace af2
