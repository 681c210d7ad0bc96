// What expressions of rules are worth at a match, and which are refused before there is one.
#include "dsl/compile/expressions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dsl/load/rule_file.h"
#include "dsl/match/given_match.h"
#include "engine/base/error.h"

namespace af2::dsl {
namespace {

const char* const kHead = "af2 1; const H = 0.5; def twice(x) = 2*x; ruleset \"s\" {}\n";

LoadedRules load(const std::string& clauses, const Registry* registry = nullptr) {
  LoadOptions options;
  options.registry = registry;
  return loadRulesFromText(
      "test.af2",
      std::string(kHead) +
          "rule \"r\" quality 1 { front d -> a -> b -> c; at c (1, 1), d (0, 1); " + clauses + " }",
      options);
}

const std::vector<Point2> kMatch{{0, 0}, {1.25, 0}, {1.5, 0.75}, {-0.25, 1.5}};

/// The value of an expression as the cost of a rule; -1e300 where it has none.
double value(const std::string& expression, int level = 2, const Registry* registry = nullptr) {
  const LoadedRules rules = load(
      "zone a, b, c, d; quad a b c d; meta { allow \"D4\"; } cost " + expression + ";", registry);
  EXPECT_TRUE(rules.rules) << expression << "\n" << toPretty(rules.diagnostics);
  if (!rules.rules) return -1e301;
  const RuleDefinition& rule = rules.rules->rules()[0].definition();
  const GivenMatch match(rule, kMatch, level,
                         {{"h", 0.75}, {"layer(c)", 3}, {"on_boundary(d)", 0}});
  return rule.cost->evaluate(match.binding()).value_or(-1e300);
}

constexpr double kNothing = -1e300;

TEST(Expressions, DoArithmetic) {
  EXPECT_DOUBLE_EQ(value("1 + 2*3 - 4/8"), 6.5);
  EXPECT_DOUBLE_EQ(value("-2^2 + 2^-1"), -3.5);
  EXPECT_DOUBLE_EQ(value("sqrt(2)^2"), 2.0000000000000004);
  EXPECT_DOUBLE_EQ(value("min(3, 1, 2) + max(3, 1, 2) + clamp(5, 0, 4) + abs(-1)"), 9);
  EXPECT_DOUBLE_EQ(value("sin(30deg) + cos(90deg) + tan(45deg)"), 1.5);
  EXPECT_DOUBLE_EQ(value("atan2(1, 1)/45deg"), 1);
  EXPECT_DOUBLE_EQ(value("if q < 2 then 1 else 3 + class"), 5);
  EXPECT_DOUBLE_EQ(value("twice(H)"), 1);
}

TEST(Expressions, DoVectorAlgebra) {
  EXPECT_DOUBLE_EQ(value("c.x + (c - b).y"), 2.25);
  EXPECT_DOUBLE_EQ(value("mid(a, b).x"), 0.625);
  EXPECT_DOUBLE_EQ(value("lerp(a, b, 2).x + lerp(1, 3, 0.5)"), 4.5);
  EXPECT_DOUBLE_EQ(value("centroid(a, b, c, d).y"), 0.5625);
  EXPECT_DOUBLE_EQ(value("perp(b - a).y + rot(b - a, 90deg).y + rot(b - a, -90deg).y"), 1.25);
  EXPECT_DOUBLE_EQ(value("len(unit(c - d))"), 1);
  EXPECT_DOUBLE_EQ(value("dot(b - a, c - a) + cross(b - a, c - a)"), 1.25 * 1.5 + 1.25 * 0.75);
  EXPECT_DOUBLE_EQ(value("dist(a, b) + foot(c, a, b).x + reflect(c, a, b).y"), 1.25 + 1.5 - 0.75);
  EXPECT_DOUBLE_EQ(value("cut(a, (1, 1), b, (0, 1)).y"), 1.25);
}

TEST(Expressions, MeasureAnglesCounterClockwise) {
  EXPECT_DOUBLE_EQ(value("angle(a + (0, 1), a, b)/90deg"), 1);
  EXPECT_DOUBLE_EQ(value("angle(b, a, a + (0, 1))/90deg"), 3);
  EXPECT_DOUBLE_EQ(value("angle(b, a, b)/360deg"), 1);
  EXPECT_DOUBLE_EQ(value("bisector(a + (0, 1), a, b).x*sqrt(2)"), 1);
  EXPECT_NEAR(value("bisector(b, a, a + (0, 1)).x*sqrt(2)"), -1, 1e-15);
  EXPECT_DOUBLE_EQ(value("bisector(a - (1, 0), a, b).y"), 1);
  EXPECT_DOUBLE_EQ(value("bisector(b, a, b).x"), -1);
  EXPECT_NEAR(value("turn(b)/1deg"), 180 - std::atan2(0.75, 0.25) * 180 / M_PI, 1e-12);
  EXPECT_DOUBLE_EQ(value("corner(b)"), 1);
}

TEST(Expressions, AskAboutTheFront) {
  EXPECT_DOUBLE_EQ(value("h(c)"), 0.75);
  EXPECT_DOUBLE_EQ(value("layer(c) + layer(a)"), 3);
  EXPECT_DOUBLE_EQ(value("if on_boundary(d) then 1 else 2"), 2);
}

TEST(Expressions, AnswerWithTruth) {
  EXPECT_DOUBLE_EQ(
      value("if ccw(a, b, c) and convex(a, b, c, d) and not ccw(b, a, c) then 1 else 0"), 1);
  EXPECT_DOUBLE_EQ(value("if inside(a, disc(b, 1.25)) then 1 else 0"), 1);
  EXPECT_DOUBLE_EQ(value("if inside(a, disc(b, 1.2)) then 1 else 0"), 0);
  EXPECT_DOUBLE_EQ(value("if q in 1..3 or 1/(q - 2) > 0 then 1 else 0"), 1)
      << "no value beside a true one";
}

TEST(Expressions, HaveNoValueRatherThanNonsense) {
  EXPECT_EQ(value("1/(c.x - 1.5)"), kNothing);
  EXPECT_EQ(value("sqrt(1 - c.x)"), kNothing);
  EXPECT_EQ(value("unit((c.x - 1.5)*(b - a)).x"), kNothing);
  EXPECT_EQ(value("cut(a, b - a, c, 2*(b - a)).x"), kNothing);
  EXPECT_DOUBLE_EQ(value("if q == 2 then 1 else 1/(q - 2)"), 1)
      << "the other branch does not matter";
}

TEST(Expressions, MeasureElements) {
  EXPECT_NEAR(value("shape_size(10, a, a + (1, 0), a + (0.5, sqrt(3)/2))"), 0, 1e-13);
  EXPECT_NEAR(value("jacobian_badness(a, a + (2, 0), a + (2, 2), a + (0, 2))"), 0, 1e-15);
  EXPECT_NEAR(value("jacobian_badness(a, a + (2, 0), a + (2, 1), a + (0, 1))"), 0.125, 1e-15);
  EXPECT_NEAR(value("size_error(a, a + (2, 0), a + (2, 2), a + (0, 2))"), 2, 1e-15);
  EXPECT_NEAR(value("scaled_jacobian(a, a + (1, 0), a + (2, 1), a + (1, 1))"), std::sqrt(0.5),
              1e-15);
  EXPECT_NEAR(value("min_angle(a, a + (1, 0), a + (0, 1))/45deg"), 1, 1e-15);
}

TEST(Expressions, CallWhatIsRegistered) {
  Registry registry;
  registry.addFunction(
      {"half", "n", 'n', [](std::span<const double> n) { return std::optional(n[0] / 2); }});
  registry.addFunction({"wide", "pv", 't', [](std::span<const double> n) {
                          return std::optional(n[0] + n[2] > 1 ? 1.0 : 0.0);
                        }});
  registry.addMetric("mine", std::make_shared<ShapeSizeMetric>(10));
  EXPECT_DOUBLE_EQ(value("half(3)", 2, &registry), 1.5);
  EXPECT_DOUBLE_EQ(value("if wide(a, b - a) then 1 else 0", 2, &registry), 1);
  EXPECT_NEAR(value("mine(a, a + (1, 0), a + (0.5, sqrt(3)/2))", 2, &registry), 0, 1e-13);
  EXPECT_THROW(registry.addFunction(
                   {"mid", "n", 'n', [](std::span<const double>) { return std::optional(1.0); }}),
               InputError);
}

/// Has no value for quadrilaterals, nor for triangles at some levels.
class LateMetric final : public AF2ElementMetric {
 public:
  std::optional<double> badness(std::span<const Point2>) const override { return 0; }
  std::optional<double> badnessAt(std::span<const Point2> corners, int level) const override {
    if (corners.size() == 4 || level == 7) return std::nullopt;
    return 1;
  }
};

TEST(Expressions, TellLevelsAtWhichARegisteredMetricHasNoValue) {
  Registry registry;
  registry.addMetric("late", std::make_shared<LateMetric>());
  registry.addMetric("mine", std::make_shared<ShapeSizeMetric>(10));
  LoadOptions options;
  options.registry = &registry;
  const auto toldOf = [&](const std::string& score, const std::string& element) {
    const LoadedRules loaded = loadRulesFromText(
        "test.af2",
        "af2 1;\nruleset \"s\" { elements tri, quad; score " + score + "; }\n" +
            "rule \"r\" quality 1 { at c (1, 1), d (0, 1); zone a, b, c, d; " + element + "; }",
        options);
    EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
    std::string told;
    for (const Diagnostic& d : loaded.diagnostics)
      if (d.code == Code::NoValue) told += d.message + ";";
    return told;
  };
  for (const std::string score : {"max of late", "max of late + 1"}) {
    EXPECT_EQ(toldOf(score, "tri a b c, a c d"),
              "the score of the triangle with sides of 1 has no value at level 7;");
    EXPECT_EQ(toldOf(score, "quad a b c d"),
              "the score of the unit square has no value at level 1;");
  }
  EXPECT_EQ(toldOf("max of mine", "tri a b c, a c d"), "");
}

TEST(Expressions, MakeZonesOfRegisteredShapes) {
  Registry registry;
  registry.addShape(
      {"box", "pn", [](std::span<const double> n) -> AF2FreeZoneDef::Made {
         return {std::make_unique<ConvexPolygonZone>(std::vector<Point2>{{n[0], n[1]},
                                                                         {n[0] + n[2], n[1]},
                                                                         {n[0] + n[2], n[1] + n[2]},
                                                                         {n[0], n[1] + n[2]}}),
                 Refusal::None};
       }});
  const LoadedRules rules = load("zone box(a, 2); quad a b c d;", &registry);
  ASSERT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  const auto made = rules.rules->rules()[0].definition().zone->makeFreeZone({kMatch, 1, nullptr});
  ASSERT_TRUE(made.zone);
  EXPECT_TRUE(made.zone->contains({2, 2}, ZoneBoundary::Counts));
}

TEST(Expressions, MirrorZonesOfRegisteredShapes) {
  Registry registry;
  registry.addShape({"right_of", "p", [](std::span<const double> n) -> AF2FreeZoneDef::Made {
                       return {std::make_unique<ConvexPolygonZone>(std::vector<Point2>{
                                   {n[0], n[1]}, {n[0] + 1, n[1]}, {n[0], n[1] + 2}}),
                               Refusal::None};
                     }});
  const LoadedRules rules = load("zone right_of(b); quad a b c d; mirror \"left\";", &registry);
  ASSERT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  // In the text's frame the triangle begins at b; seen from the other side, at a, and turned over.
  const auto made = rules.rules->rules()[1].definition().zone->makeFreeZone({kMatch, 1, nullptr});
  ASSERT_TRUE(made.zone);
  const double left = made.zone->boundingBox().low.x;
  EXPECT_DOUBLE_EQ(left, -1);
  EXPECT_TRUE(made.zone->contains({-0.9, 0.1}, ZoneBoundary::Counts));
  EXPECT_FALSE(made.zone->contains({-0.9, 1.9}, ZoneBoundary::Counts));
  EXPECT_TRUE(made.zone->contains({-0.05, 1.8}, ZoneBoundary::Counts));
  EXPECT_TRUE(made.zone->meets({-2, 1}, {2, 1}, ZoneBoundary::Ignored));
  EXPECT_FALSE(made.zone->meets({-2, 2.1}, {2, 2.1}, ZoneBoundary::Counts));
}

TEST(Expressions, KnowWhatIsInsideOfUnboundedShapes) {
  EXPECT_EQ(value("if inside(a + (5, 5), left(a, b - a)) then 1 else 0", 1), 1);
  EXPECT_EQ(value("if inside(a + (5, -5), left(a, b - a)) then 1 else 0", 1), 0);
  EXPECT_EQ(value("if inside(a + (0, 0.5), left(a, b - a) - disc(a, 1)) then 1 else 0", 1), 0);
  EXPECT_EQ(value("if inside(a + (0, 3), left(a, b - a) - disc(a, 1)) then 1 else 0", 1), 1);
  EXPECT_EQ(value("if inside(a, disc(a, 1) - disc(a, 2)) then 1 else 0", 1), 0) << "empty";
}

std::string faults(const std::string& clauses) {
  std::string codes;
  for (const Diagnostic& d : load("zone a, b, c, d; quad a b c d; " + clauses).diagnostics)
    codes += idOf(d.code) + " ";
  return codes;
}

TEST(Expressions, AreTyped) {
  EXPECT_EQ(faults("let x = 2*c + a; cost x.x;"), "A1 ") << "a weight of 3 is no point";
  EXPECT_EQ(faults("let x = q*c; cost 1;"), "A1 ");
  EXPECT_EQ(faults("cost len(a);"), "Y1 ");
  EXPECT_EQ(faults("cost turn(b);"), "Y1 ");
  EXPECT_EQ(faults("require turn(b) < 90;"), "Y2 ");
  EXPECT_EQ(faults("require 1;"), "Y1 ");
  EXPECT_EQ(faults("cost 1/0;"), "Y4 ");
  EXPECT_EQ(faults("cost mid(a);"), "Y6 ");
  EXPECT_EQ(faults("cost a*b;"), "Y2 ");
  EXPECT_EQ(faults("cost nothing;"), "R1 ");
  EXPECT_EQ(faults("cost later; let later = 1;"), "R1 ");
}

TEST(Mirrors, EvaluateTheSameTextInTheReflectedFrame) {
  const LoadedRules rules = loadRulesFromText("test.af2", R"(af2 1; ruleset "s" {}
    rule "right" quality 1 {
      front a -> b -> c;
      at c (1.5, 0.8) ~ (1, 0.5, 2);
      slope b -> c ~ (1, 0.25, 1);
      require turn(b) > 60deg, len(c - a) > 0.1;
      new d = b + h(b)*bisector(a, b, c), e = a + (c - b);
      zone poly(a, b, arc(b + (0.7, 0.1), c), d, e) | sector(a, 0.5, 0deg, 120deg) & left(a, b - a);
      tri a b e, b d e, b c d;
      cost c.x;
      mirror "left";
    })");
  ASSERT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  const RuleDefinition& right = rules.rules->rules()[0].definition();
  const RuleDefinition& left = rules.rules->rules()[1].definition();
  EXPECT_EQ(left.vertices[2].reference, (Point2{-0.5, 0.8}));
  EXPECT_EQ(left.vertices[2].tolerance, (ToleranceForm{1, -0.5, 2}));
  EXPECT_EQ(left.edges[1], (PatternEdge{2, 0, ToleranceForm{1, -0.25, 1}}));
  const double length = 1.2;
  const auto reflected = [&](Point2 p) { return Point2{length - p.x, p.y}; };
  const std::vector<Point2> matchR{{0, 0}, {length, 0}, {1.6, 0.9}},
      matchL{{0, 0}, {length, 0}, reflected(matchR[2])};
  const GivenMatch here(right, matchR, 2), there(left, matchL, 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const Point2 r = reflected(*right.newVertices[i]->transformPoint(here.binding()));
    const Point2 l = *left.newVertices[i]->transformPoint(there.binding());
    EXPECT_NEAR(l.x, r.x, 1e-12);
    EXPECT_NEAR(l.y, r.y, 1e-12);
  }
  EXPECT_NEAR(*left.cost->evaluate(there.binding()), *right.cost->evaluate(here.binding()), 1e-12);
  const auto zoneR = right.zone->makeFreeZone(here.binding()),
             zoneL = left.zone->makeFreeZone(there.binding());
  ASSERT_TRUE(zoneR.zone && zoneL.zone);
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 40; ++k) {
      const Point2 p{-1.013 + 0.1 * i, -1.027 + 0.1 * k};
      EXPECT_EQ(zoneR.zone->contains(p, ZoneBoundary::Counts),
                zoneL.zone->contains(reflected(p), ZoneBoundary::Counts))
          << p.x << " " << p.y;
    }
}

}  // namespace
}  // namespace af2::dsl
