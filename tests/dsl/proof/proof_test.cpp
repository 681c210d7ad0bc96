#include "dsl/proof/proof.h"

#include <gtest/gtest.h>

#include <random>

#include "dsl/load/rule_file.h"
#include "dsl/proof/linear_forms.h"
#include "dsl/proof/rule_sample.h"
#include "dsl/proof/zone_depth.h"
#include "engine/base/predicates.h"
#include "quad_rules.h"

namespace af2::dsl {
namespace {

/// A new corner straight above a, at the height of c: not a combination of zone corners.
AF2Rule quadRight(double overhang) {
  RuleDefinition rule =
      testing::ruleWith("quad right", 1, {{"c", {1, 1}, ToleranceForm{4, 0, 4}}}, {{0, 1}, {1, 2}});
  rule.newVertexNames = {"d"};
  rule.newVertices = {std::make_shared<AffinePointTransform>(
      Point2{}, std::vector<AffinePointTransform::Term>{{2, 0, 0, 0, 1}})};
  rule.zone = testing::zone(
      {testing::at(0),
       testing::at(1),
       testing::at(2),
       {std::make_shared<AffinePointTransform>(
           Point2{-overhang, 0}, std::vector<AffinePointTransform::Term>{{2, 0, 0, 0, 1.5}})}});
  rule.elements = {testing::quad(0, 1, 2, 3)};
  return AF2Rule(rule);
}

RuleSet setOf(AF2Rule rule) {
  RuleSetDefinition set = testing::triangleSetDefinition();
  set.rules = {std::move(rule)};
  return RuleSet(std::move(set));
}

bool positive(const AF2Rule& rule) {
  ProofEffort effort = kUsualEffort;
  return provesPositive(setOf(rule), rule, 1, effort);
}
bool covered(const AF2Rule& rule) {
  ProofEffort effort = kUsualEffort;
  return provesCovered(setOf(rule), rule, 1, effort);
}

TEST(Proof, CutsTheToleranceIntoBoxesWhereCombinationsDoNotDo) {
  EXPECT_TRUE(positive(quadRight(0.5)));
  EXPECT_TRUE(covered(quadRight(0.5)));
}

TEST(Proof, DoesNotProveWhatIsFalse) {
  EXPECT_FALSE(covered(quadRight(-0.2)));  // the zone ends to the right of d
  EXPECT_FALSE(covered(testing::quadPRight150()));
}

TEST(Proof, NeedsAZoneThatItKnows) {
  RuleDefinition rule = testing::freeTriangle().definition();
  class NoZone final : public AF2FreeZoneDef {
    Made makeFreeZone(const AF2Binding&) const override { return {}; }
  };
  rule.zone = std::make_shared<NoZone>();
  EXPECT_TRUE(positive(AF2Rule(rule)));
  EXPECT_FALSE(covered(AF2Rule(rule)));
}

TEST(Proof, NeedsPlacementsThatItKnows) {
  class Somewhere final : public AF2PointTransform {
    std::optional<Point2> transformPoint(const AF2Binding&) const override {
      return Point2{0.5, 0.8};
    }
  };
  RuleDefinition rule = testing::freeTriangle().definition();
  rule.newVertices = {std::make_shared<Somewhere>()};
  EXPECT_FALSE(positive(AF2Rule(rule)));
}

LoadedRules rulesOf(const std::string& body) {
  return loadRulesFromText(
      "r.af2",
      "af2 1; ruleset \"r\" { elements tri, quad; classes 1..30; }\nrule \"r\" quality 1 {" + body +
          "}\n");
}

bool isProven(const std::string& body, decltype(provesPositive) proves, int level = 1) {
  const LoadedRules loaded = rulesOf(body);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  ProofEffort effort{20000, 1e-4};
  return loaded.rules && proves(*loaded.rules, loaded.rules->rules()[0], level, effort);
}

TEST(Proof, FollowsExpressionsThatAreNotAffine) {
  const std::string apex = "new c = mid(a, b) + sqrt(1 - 0.25*len(b - a)) * perp(unit(b - a));";
  EXPECT_TRUE(isProven(apex + "zone a, b, c; tri a b c;", provesPositive));
  EXPECT_TRUE(isProven(apex + "zone a, b, c; tri a b c;", provesCovered));
  const std::string spoke =
      "front a -> b -> c; at c (1, 1); require turn(b) in 60deg..120deg, len(c - b) in 0.5..1.5;"
      "new d = a + rot(b - a, 90deg) * (0.5 + 0.2*abs(len(c - b) - 1));";
  EXPECT_TRUE(isProven(spoke + "zone (hull(a, b, c, d)); tri a b d, b c d;", provesCovered));
}

TEST(Proof, FollowsConditions) {
  const std::string pattern = "at c (0.5, 0.866) ~ 0.5;";
  EXPECT_FALSE(isProven(pattern + "zone (hull(a, b, c)); tri a b c;", provesPositive));
  EXPECT_TRUE(
      isProven(pattern + "require c.y > 0.1; zone (hull(a, b, c)); tri a b c;", provesPositive));
  EXPECT_TRUE(
      isProven(pattern + "require ccw(a, b, c); zone (hull(a, b, c)); tri a b c;", provesPositive));
  EXPECT_TRUE(
      isProven("front a -> b -> c; at c (0.5, 0.866) ~ 0.5;"
               "require turn(b) < 150deg, not (c.y < 0.05); zone (hull(a, b, c)); tri a b c;",
               provesPositive));
}

TEST(Proof, FollowsZonesOfManyShapes) {
  const std::string free = "new c = mid(a, b) + (0, 0.8); tri a b c; zone ";
  for (const char* zone :
       {"(disc(mid(a, b), 1));", "sector(mid(a, b), 1, 0deg, 180deg);",
        "disc(mid(a, b), 1) & left(a, b - a);", "(disc(c, 0.1) | poly(a, b, c));",
        "(grow(hull(a, b, c), 0.2) => grow(hull(a, b, c), 0));",
        "poly(a, b, arc(b + (0.2, 0.3), c), arc(a + (-0.2, 0.3), a));",
        "poly(a, b, arc(c + (0, 0.3), a));",
        "(poly(a, b, b + (1, 1), a + (-1, 1)) - disc(c + (0, 0.5), 0.3));",
        "poly(a, b, b + (0.5, 0.2), c, a + (-0.5, 0.2));"}) {
    EXPECT_TRUE(isProven(free + zone, provesCovered)) << zone;
    EXPECT_TRUE(isProven(free + zone, provesCovered, 7)) << zone;
  }
  EXPECT_TRUE(
      isProven("new c = mid(a, b) + (0, 0.8); tri a b c; zone disc(mid(a, b), 1) when "
               "len(b - a) > 1; zone disc(mid(a, b), 0.85);",
               provesCovered));
  for (const char* zone : {"(disc(mid(a, b), 0.75));", "sector(mid(a, b), 1, 0deg, 90deg);",
                           "(disc(c, 0.1) | poly(a, b, b + (0, 0.7), a + (0, 0.7)));",
                           "poly(a, b, arc(b + (0.1, 0), c + (0.1, -0.1)), a + (0, 0.2));",
                           "(poly(a, b, b + (1, 1), a + (-1, 1)) - disc(c + (0, 0.2), 0.3));"})
    EXPECT_FALSE(isProven(free + zone, provesCovered)) << zone;
}

// Wherever the vertices and their neighbours are.
TEST(Proof, KnowsThatElementsWithTheOutlineOfTheZoneFillIt) {
  const std::string corners =
      "new c = after(b) + (0, 1), d = before(a) + (0, 1); quad a b c d; zone ";
  EXPECT_TRUE(isProven(corners + "poly(a, b, c, d);", provesCovered));
  EXPECT_TRUE(isProven(corners + "a, b, c, d;", provesCovered));
  EXPECT_FALSE(isProven(corners + "poly(a, b, c);", provesCovered));
  EXPECT_FALSE(isProven(corners + "poly(a, b, arc(c + (0.1, 0.2), d));", provesCovered));
  const std::string loop =
      "front a -> b -> c -> d -> e; at c (1.5, 1) ~ any, d (1, 2) ~ any, e (0, 2) ~ any;";
  EXPECT_TRUE(isProven(loop + "tri a b c, a d e, a c d; zone poly(a, b, c, d, e);", provesCovered));
  EXPECT_TRUE(isProven(loop + "tri a b c; quad a c d e; zone poly(a, b, c, d, e);", provesCovered));
}

TEST(Proof, KnowsHowFarAVertexIsFromItsPlace) {
  const std::string near = "near c of b + (0, 1) within 0.4; new d = a + (0, 1); quad a b c d;";
  EXPECT_TRUE(isProven(near + "zone (hull(a, b, c, d));", provesPositive));
  EXPECT_TRUE(isProven(near + "zone (disc(b + (-0.5, 0.5), 1.4));", provesCovered));
  EXPECT_FALSE(isProven(near + "zone (disc(b + (-0.5, 0.5), 1));", provesCovered));
  const std::string far = "near c of b + (0, 1) within 2; new d = a + (0, 1); quad a b c d;";
  EXPECT_FALSE(isProven(far + "zone (hull(a, b, c, d));", provesPositive));
}

TEST(Proof, IsDoneSoonForUnionsOfManyShapes) {
  std::string zone = "hull(a, b, c)";
  for (int i = 0; i < 12; ++i) zone += " | disc(b + (" + std::to_string(0.1 * i) + ", 0), 0.1)";
  EXPECT_TRUE(
      isProven("new c = mid(a, b) + (0, 0.8); tri a b c; zone " + zone + ";", provesCovered));
}

TEST(Proof, DoesNotTakeAFlatElementForAPositiveOne) {
  const std::string sinking =
      "new c = mid(a, b) + (0, max(0, 0.9 - 0.1*q));"
      "zone (disc(mid(a, b), 2)); tri a b c;";
  EXPECT_TRUE(isProven(sinking, provesPositive, 5));
  EXPECT_FALSE(isProven(sinking, provesPositive, 12));
}

// ---- random rules ------------------------------------------------------------------------------

/// Text of rules with zones of all kinds, good and bad ones.
class RuleWriter {
 public:
  explicit RuleWriter(unsigned seed) : random_(seed) {}

  std::string write() {
    const bool isQuad = pick(2) == 0;
    std::string text = isQuad ? "at c (1, 1) ~ 2;" : "at c (0.5, 0.9) ~ 1.5;";
    if (pick(2) == 0)
      text += isQuad ? "require convex(a, b, c, a + (0, 0.3));" : "require c.y > 0.2;";
    if (pick(3) == 0) text += "require len(c - b) in 0.5..1.6, dist(a, c) > 0.4;";
    if (isQuad)
      text += "new d = " +
              of({"a + (c - b)", "a + len(c - b)*unit(perp(b - a))",
                  "lerp(a, c, 0.5) + 0.6*perp(unit(c - a))", "a + rot(c - b, 0.3 * (c.x - 1))",
                  "a + max(0.5, abs(c.y)) * bisector(b, a, c)"}) +
              ";";
    return text + zone(isQuad) + (isQuad ? "quad a b c d;" : "tri a b c;");
  }

 private:
  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  std::string of(const std::vector<std::string>& all) {
    return all[static_cast<std::size_t>(pick(static_cast<int>(all.size())))];
  }
  std::string number() { return std::to_string(0.1 * (1 + pick(15))); }

  std::string shape(const std::string& last, int depth) {
    const std::string all = "a, b, c" + last;
    switch (pick(depth > 0 ? 10 : 6)) {
      case 0:
        return "poly(" + all + ")";
      case 1:
        return "disc(centroid(" + all + "), " + number() + ")";
      case 2:
        return "poly(a, b, arc(b + (" + number() + ", 0.5), c)" + last + ")";
      case 3:
        return "sector(mid(a, b), 2.2, -20deg, 20deg + " + number() + " * 180deg)";
      case 4:
        return "left(a, b - a) & disc(mid(a, c), " + number() + " + 0.4)";
      case 5:
        return "hull(" + all + ")";
      case 6:
        return "(" + shape(last, depth - 1) + " | " + shape(last, depth - 1) + ")";
      case 7:
        return "(" + shape(last, depth - 1) + " & " + shape(last, depth - 1) + ")";
      case 8:
        return "(" + shape(last, depth - 1) + " - disc(c + (0.3, " + number() + "), 0.3))";
      default:
        return "grow(" + shape(last, depth - 1) + ", 0.2)";
    }
  }

  std::string zone(bool isQuad) {
    const std::string last = isQuad ? ", d" : "";
    if (pick(3) == 0)
      return "zone a, b, c + (" + number() + ", 0) => c" + last + ", lerp(c, a, " + number() + ");";
    return "zone (" + shape(last, 2) + ");";
  }

  std::mt19937 random_;
};

/// Whether an element turns over, or has a place that its zone does not see.
struct Faults {
  bool isInverted = false, isUncovered = false;
};

Faults faultsOf(const SampledMatch& one) {
  Faults faults;
  if (!one.zone || !one.placed) return faults;
  for (const RuleElement& element : one.match.rule().definition().elements) {
    const auto corners = cornersOf(element, *one.placed);
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
      faults.isInverted |=
          orientation(corners[i], corners[(i + 1) % n], corners[(i + 2) % n]) != Turn::Left;
    if (!faults.isInverted && unseenPlace(*one.zone, corners)) faults.isUncovered = true;
  }
  return faults;
}

TEST(Proof, IsNeverContradictedBySamples) {
  int positives = 0, covers = 0;
  for (unsigned seed = 1; seed <= 160; ++seed) {
    const std::string body = RuleWriter(seed).write();
    const LoadedRules loaded = rulesOf(body);
    if (!loaded.rules) continue;
    const AF2Rule& rule = loaded.rules->rules()[0];
    const int level = 1 + static_cast<int>(seed % 4);
    ProofEffort effort = kUsualEffort, other = kUsualEffort;
    const bool isPositive = provesPositive(*loaded.rules, rule, level, effort);
    const bool isCovered = provesCovered(*loaded.rules, rule, level, other);
    positives += isPositive;
    covers += isCovered;
    if (!isPositive && !isCovered) continue;
    for (const SampledMatch& one : sampleRule(*loaded.rules, 0, level, 300, seed).matches) {
      const Faults faults = faultsOf(one);
      ASSERT_FALSE(isPositive && faults.isInverted) << body;
      ASSERT_FALSE(isCovered && faults.isUncovered) << body;
    }
  }
  EXPECT_GT(positives, 30);
  EXPECT_GT(covers, 20);
}

LinearPoint at(double x, double y) { return {{x, {}}, {y, {}}}; }

TEST(ConvexCombinations, AreFoundForPointsInside) {
  const std::vector<LinearPoint> square{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
  EXPECT_EQ(convexCombinations(at(1, 1), square), (std::vector<Weights>{{0, 0, 1, 0}}));
  EXPECT_FALSE(convexCombinations(at(0.3, 0.6), square).empty());
  EXPECT_TRUE(convexCombinations(at(1.1, 0.6), square).empty());
}

TEST(TurnLeftInConvex, HoldsForCornersInOrder) {
  const std::vector<LinearPoint> square{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
  EXPECT_TRUE(turnLeftInConvex(square[0], square[1], square[3], square));
  EXPECT_TRUE(turnLeftInConvex(square[3], square[0], square[2], square));
  EXPECT_FALSE(turnLeftInConvex(square[0], square[3], square[1], square));
  EXPECT_TRUE(turnLeftInConvex(square[0], square[1], at(0.5, 0.5), square));
  EXPECT_FALSE(turnLeftInConvex(square[0], square[2], at(0.5, 0.5), square));
}

}  // namespace
}  // namespace af2::dsl
