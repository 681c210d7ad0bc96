// The reference cases are those of MeshKit's tests of its default triangle rules
// (test/algs/AdvFront/dfltTriRules.cpp), in the coordinates of their chart: origin (-0.5, 0, 0.5),
// scale 0.125.
#include "engine/single_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "engine/error.h"
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

FrontPiece corner(Point2 c) { return {{{0, 0}, {1, 0}, c}, {{0, 1, 2}}, {}, {0, 1}}; }

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

// ---- refusals ----------------------------------------------------------------------------------

class Constant final : public AF2BindingFunction {
 public:
  explicit Constant(std::optional<double> value) : value_(value) {}
  std::optional<double> evaluate(const AF2Binding&) const override { return value_; }

 private:
  std::optional<double> value_;
};
std::shared_ptr<const AF2BindingFunction> constant(std::optional<double> value) {
  return std::make_shared<Constant>(value);
}

class NoPoint final : public AF2PointTransform {
  std::optional<Point2> transformPoint(const AF2Binding&) const override { return std::nullopt; }
};
class NoMetric final : public AF2ElementMetric {
  std::optional<double> badness(std::span<const Point2>) const override { return std::nullopt; }
};
class NoShape final : public AF2FreeZoneDef {
  Made makeFreeZone(const AF2Binding&) const override { return {nullptr, Refusal::Shape}; }
};

/// A free triangle with its apex at (0.5, 0.866), in ways to be spoilt.
struct Spoilt {
  RuleDefinition rule = freeTriangle().definition();
  RuleSetDefinition set = triangleSetDefinition();
  FrontPiece piece{{{-1, 0}, {0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2, 3}}, {}, {1, 2}};

  RuleRefusal refusal() {
    set.rules = {AF2Rule(rule)};
    const SingleStep step = takeSingleStep(RuleSet(set), piece);
    EXPECT_NE(step.rule.has_value(), !step.refusals.empty());
    return step.refusals.empty() ? RuleRefusal{} : step.refusals[0];
  }
};

struct Fault {
  Refusal reason;
  std::function<void(Spoilt&)> spoil;
};

/// One way to earn each reason, in the order in which reasons are checked.
std::vector<Fault> faults() {
  return {
      {Refusal::Class, [](Spoilt& s) { s.rule.firstLevel = 2; }},
      {Refusal::Pattern,
       [](Spoilt& s) {
         // The front goes straight on where the rule wants it to turn.
         s.rule.vertices.push_back({"f", {1, 2}, ToleranceForm{}});
         s.rule.edges.push_back({1, 2});
         s.rule.elements = {{{0, 1, 3, -1}}};
       }},
      {Refusal::Require, [](Spoilt& s) { s.rule.requirements = {constant(0)}; }},
      {Refusal::NoValue, [](Spoilt& s) { s.rule.newVertices = {std::make_shared<NoPoint>()}; }},
      {Refusal::Shape, [](Spoilt& s) { s.rule.zone = std::make_shared<NoShape>(); }},
      {Refusal::ZoneHitByVertex,
       [](Spoilt& s) {
         s.piece.isolated.push_back(s.piece.vertices.size());
         s.piece.vertices.push_back({.5, .5});
       }},
      {Refusal::ZoneHitByEdge,
       [](Spoilt& s) {
         const std::size_t v = s.piece.vertices.size();
         s.piece.vertices.push_back({4, .6});
         s.piece.vertices.push_back({-4, .6});
         s.piece.chains.push_back({v, v + 1});
       }},
      {Refusal::Inverted,
       [](Spoilt& s) {
         s.rule.newVertices = {combine({.5, -.866}, {})};
       }},
      {Refusal::Score,
       [](Spoilt& s) { s.set.acceptance = std::make_shared<ScoreBound>(std::vector{-1.0}); }},
  };
}

TEST(Refusal, NothingIsRefusedWhereNothingIsWrong) {
  EXPECT_EQ(Spoilt().refusal().reason, Refusal::None);
}

TEST(Refusal, IsToldForEachFault) {
  for (const Fault& fault : faults()) {
    Spoilt s;
    fault.spoil(s);
    EXPECT_EQ(toString(s.refusal().reason), std::string(toString(fault.reason)));
  }
}

TEST(Refusal, NamesTheFirstOfTwoFaultsInTheStatedOrder) {
  const std::vector<Fault> all = faults();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      // These two both set the position of the new vertex.
      if (all[i].reason == Refusal::NoValue && all[k].reason == Refusal::Inverted) continue;
      for (bool firstIsFirst : {true, false}) {
        Spoilt s;
        all[firstIsFirst ? i : k].spoil(s);
        all[firstIsFirst ? k : i].spoil(s);
        EXPECT_EQ(toString(s.refusal().reason), std::string(toString(all[i].reason)))
            << "with " << toString(all[k].reason);
      }
    }
  }
}

TEST(Refusal, ConvexityIsTheCommonestKindOfShape) {
  Spoilt s;
  s.rule.zone = zone({at(0), at(1), {combine({.5, .1}, {})}, {combine({.5, 2}, {})}});
  EXPECT_EQ(s.refusal().reason, Refusal::Convexity);
}

TEST(Refusal, NoValueOfARequirementACostAMetricOrANonFinitePoint) {
  Spoilt s;
  s.rule.requirements = {constant(std::nullopt)};
  EXPECT_EQ(s.refusal().reason, Refusal::NoValue);
  s = Spoilt();
  s.rule.cost = constant(std::nullopt);
  EXPECT_EQ(s.refusal().reason, Refusal::NoValue);
  s = Spoilt();
  s.rule.cost = constant(std::numeric_limits<double>::infinity());
  EXPECT_EQ(s.refusal().reason, Refusal::NoValue);
  s = Spoilt();
  s.set.metric = std::make_shared<NoMetric>();
  EXPECT_EQ(s.refusal().reason, Refusal::NoValue);
}

TEST(Refusal, RequirementsHoldIfTheyAreNotZero) {
  Spoilt s;
  s.rule.requirements = {constant(1), constant(-.5)};
  EXPECT_EQ(s.refusal().reason, Refusal::None);
  s.rule.requirements.push_back(constant(0));
  EXPECT_EQ(s.refusal().reason, Refusal::Require);
}

TEST(Refusal, TellsWhatHitTheZone) {
  Spoilt s;
  faults()[5].spoil(s);
  EXPECT_EQ(s.refusal().from, VertexId(4u));
  EXPECT_TRUE(s.refusal().to.isNone());
  s = Spoilt();
  faults()[6].spoil(s);
  EXPECT_EQ(s.refusal().from, VertexId(4u));
  EXPECT_EQ(s.refusal().to, VertexId(5u));
}

TEST(Refusal, OfTheMatchThatCameFarthest) {
  RuleSetDefinition set = triangleSetDefinition();
  set.rules = {visAVis()};
  // Two candidates: in one's zone lies the other; the other's own zone is cut by an edge.
  FrontPiece piece{
      {{0, 0}, {1, 0}, {.5, .9}, {.5, .6}, {3, .3}, {-3, .3}}, {{0, 1}, {4, 5}}, {2, 3}, {0, 1}};
  const SingleStep step = takeSingleStep(RuleSet(set), piece);
  ASSERT_EQ(step.refusals.size(), 1u);
  EXPECT_EQ(step.refusals[0].reason, Refusal::ZoneHitByEdge);
}

TEST(Refusal, OfARuleThatIsBeaten) {
  RuleSetDefinition set = triangleSetDefinition();
  RuleDefinition worse = freeTriangle().definition();
  worse.name = "worse";
  worse.cost = constant(.5);
  set.rules = {AF2Rule(worse), freeTriangle()};
  const FrontPiece piece{{{0, 0}, {1, 0}}, {{0, 1}}, {}, {0, 1}};
  const SingleStep step = takeSingleStep(RuleSet(set), piece);
  EXPECT_EQ(step.rule, 1u);
  ASSERT_EQ(step.refusals.size(), 1u);
  EXPECT_EQ(step.refusals[0].reason, Refusal::Beaten);
}

// ---- which rule wins ---------------------------------------------------------------------------

TEST(Choice, CostIsAddedToTheScore) {
  Spoilt s;
  s.set.rules = {AF2Rule(s.rule)};
  const double plain = takeSingleStep(RuleSet(s.set), s.piece).score;
  s.rule.cost = constant(.75);
  s.set.rules = {AF2Rule(s.rule)};
  EXPECT_DOUBLE_EQ(takeSingleStep(RuleSet(s.set), s.piece).score, plain + .75);
}

TEST(Choice, AmongEqualScoresTheSmallerPriorityThenTheFirstInTheFile) {
  RuleSetDefinition set = triangleSetDefinition();
  RuleDefinition one = freeTriangle().definition(), two = one;
  const FrontPiece piece{{{0, 0}, {1, 0}}, {{0, 1}}, {}, {0, 1}};
  set.rules = {AF2Rule(one), AF2Rule(two)};
  EXPECT_EQ(takeSingleStep(RuleSet(set), piece).rule, 0u);
  one.priority = 2;
  two.priority = 1;
  set.rules = {AF2Rule(one), AF2Rule(two)};
  EXPECT_EQ(takeSingleStep(RuleSet(set), piece).rule, 1u);
}

TEST(Choice, AmongEqualMatchesTheSmallestVertices) {
  RuleSetDefinition set = triangleSetDefinition();
  RuleDefinition rule = visAVis().definition();
  rule.zone = zone({at(0), at(1), {combine({0, .01}, {{1, 1}})}, {combine({0, .01}, {{0, 1}})}});
  set.rules = {AF2Rule(rule)};
  // Mirror images: their scores are equal.
  for (bool isSwapped : {false, true}) {
    FrontPiece piece{{{0, 0}, {1, 0}, {.25, 1}, {.75, 1}}, {{0, 1}}, {2, 3}, {0, 1}};
    if (isSwapped) std::swap(piece.vertices[2], piece.vertices[3]);
    EXPECT_EQ(takeSingleStep(RuleSet(set), piece).matched, (std::vector<std::size_t>{0, 1, 2}));
  }
}

TEST(Choice, ScoreOfSeveralElementsIsTheirMaximumSumOrMean) {
  RuleSetDefinition set = triangleSetDefinition();
  set.rules = {right120()};
  const FrontPiece piece = corner({1.25, .75});
  std::vector<double> scores;
  for (ScoreOf of : {ScoreOf::Max, ScoreOf::Sum, ScoreOf::Mean}) {
    set.scoreOf = of;
    scores.push_back(takeSingleStep(RuleSet(set), piece).score);
  }
  EXPECT_GT(scores[1], scores[0]);
  EXPECT_DOUBLE_EQ(scores[2], scores[1] / 2);
  EXPECT_GE(scores[0], scores[2]);
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
