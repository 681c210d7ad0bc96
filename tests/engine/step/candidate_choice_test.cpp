// Why rules are refused, and which of several wins.
#include "engine/step/candidate_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "engine/step/single_step.h"
#include "tests/support/triangle_rules.h"

namespace af2 {
namespace {

using namespace af2::testing;

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

// The vertex between p and a is off the edge from a to p by rounding alone.
TEST(Refusal, IsForNewEdgesAlongTheFront) {
  for (const double p : {0.0, 1e-17, -1e-17}) {
    Spoilt s;
    s.rule = ruleWith("to a vertex", 1, {{"c", {0, 1}, ToleranceForm{1, 0, 1}}}, {{0, 1}});
    s.rule.zone = zone({at(0), at(1), at(2)});
    s.rule.elements = {{{0, 1, 2, -1}}};
    s.piece = {{{p, 1}, {0, 0.5}, {0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2, 3, 4}}, {}, {2, 3}};
    EXPECT_NE(s.refusal().reason, Refusal::None) << p;
    s.piece.vertices[1].x = -0.1;  // now there is room between
    EXPECT_EQ(s.refusal().reason, Refusal::None) << p;
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

/// A cost that says how low it can be, and counts how often it is evaluated.
class CountedCost final : public AF2BindingFunction {
 public:
  CountedCost(double value, int& count) : value_(value), count_(count) {}
  std::optional<double> evaluate(const AF2Binding&) const override {
    ++count_;
    return value_;
  }
  double leastAt(int) const override { return value_; }

 private:
  double value_;
  int& count_;
};

/// The rule that the front chooses, and how often the costs of the first and the second rule were
/// evaluated. A blocked rule has a zone of no shape.
struct Chosen {
  int first = 0, second = 0;
  std::optional<std::size_t> rule;

  Chosen(double firstCost, double secondCost, bool isSecondBlocked = false) {
    Spoilt s;
    s.rule.cost = std::make_shared<CountedCost>(firstCost, first);
    s.set.rules = {AF2Rule(s.rule)};
    s.rule.name = "another";
    s.rule.cost = std::make_shared<CountedCost>(secondCost, second);
    if (isSecondBlocked) s.rule.zone = std::make_shared<NoShape>();
    s.set.rules.emplace_back(s.rule);
    const RuleSet set(s.set);
    rule = SingleStepper(set).chosenRule(s.piece);
  }
};

TEST(LeastScore, RulesThatCannotBeBetterAreNotEvaluated) {
  const Chosen chosen(0.5, 0.1);
  EXPECT_EQ(chosen.rule, 1u);
  EXPECT_EQ(chosen.second, 1);
  EXPECT_EQ(chosen.first, 0);
}

TEST(LeastScore, TheyAreWhereTheBetterOneIsNotFree) {
  const Chosen chosen(0.5, 0.1, true);
  EXPECT_EQ(chosen.rule, 0u);
  EXPECT_EQ(chosen.first, 1);
}

TEST(LeastScore, TiesGoToTheFirstRuleAsEver) { EXPECT_EQ(Chosen(0.1, 0.1).rule, 0u); }

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

// What is plainly in the way is seen before zones are made; explanations always make them.
TEST(Choice, TakesWhatTheExactTestsFindFree) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(0.2, 3.1), length(0.2, 3), small(-1e-3, 1e-3);
  const double sideOfZone = std::atan2(0.7, -0.5);
  const auto end = [&](bool isNearSide) {
    const double turn = isNearSide ? sideOfZone + small(random) : angle(random), l = length(random);
    return Point2{l * std::cos(turn), l * std::sin(turn)};
  };
  int taken = 0, refused = 0;
  for (const AF2Rule& rule : {freeTriangle(), right60(), right120(), visAVis()}) {
    RuleSetDefinition definition = triangleSetDefinition();
    definition.rules = {rule};
    const RuleSet set(definition);
    SingleStepper stepper(set);
    for (int i = 0; i < 2000; ++i) {
      const Point2 before = end(i % 3 == 0), after = end(i % 5 == 0);
      const SingleStep step = stepper.take(
          {{before, {0, 0}, {1, 0}, {1 - after.x, after.y}}, {{0, 1, 2, 3}}, {}, {1, 2}});
      ++(step.rule ? taken : refused);
      ASSERT_TRUE(step.rule || step.refusals[0].reason != Refusal::Beaten) << i;
    }
  }
  EXPECT_GT(taken, 500);
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace af2
