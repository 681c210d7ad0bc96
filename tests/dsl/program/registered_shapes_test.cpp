// Zone shapes that a program registers, joined with those of the language.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dsl/load/rule_file.h"
#include "dsl/program/registry.h"
#include "dsl/program/shape_program.h"
#include "dsl/shapes/covering_zone.h"
#include "tests/support/meshing.h"

namespace af2::dsl {
namespace {

using enum ZoneBoundary;

/// Answers as an exact zone does, and shows nothing else of it.
template <class Base>
class OpaqueAs : public Base {
 public:
  explicit OpaqueAs(std::unique_ptr<const AF2FreeZone> zone) : zone_(std::move(zone)) {}
  Box2 boundingBox() const override { return zone_->boundingBox(); }
  bool contains(Point2 p, ZoneBoundary boundary) const override {
    return zone_->contains(p, boundary);
  }
  bool meets(Point2 p, Point2 q, ZoneBoundary boundary) const override {
    return zone_->meets(p, q, boundary);
  }

 protected:
  std::unique_ptr<const AF2FreeZone> zone_;
};

using Opaque = OpaqueAs<AF2FreeZone>;

class OpaqueCovering final : public OpaqueAs<CoveringZone> {
 public:
  using OpaqueAs::OpaqueAs;
  bool covers(Point2 p, Point2 q) const override { return dsl::covers(*zone_, p, q); }
};

template <class Zone>
AF2FreeZoneDef::Made opaque(const Shape& shape) {
  MadeZone made = makeZone(shape);
  if (!made.zone) return {nullptr, made.refusal};
  return {std::make_unique<Zone>(std::move(made.zone)), Refusal::None};
}

/// `round(p, r)` is disc(p, r), `seen(p, r)` too, but does not say which edges it covers; `half(p,
/// v)` is an unbounded one.
Registry registry() {
  const auto disc = [](std::span<const double> n) { return Shape::disc({n[0], n[1]}, n[2]); };
  Registry registry;
  registry.addShape({"round", "pn", [disc](std::span<const double> n) {
                       return opaque<OpaqueCovering>(disc(n));
                     }});
  registry.addShape(
      {"seen", "pn", [disc](std::span<const double> n) { return opaque<Opaque>(disc(n)); }});
  return registry;
}

LoadedRules load(const std::string& text) {
  static const Registry shapes = registry();
  LoadOptions options;
  options.registry = &shapes;
  return loadRulesFromText("test.af2", "af2 1;\nruleset \"s\" { elements quad, tri; }\n" + text,
                           options);
}

/// A rule with one new quad and this zone.
std::string quadWith(const std::string& zones) {
  return "rule \"r\" quality 1 { front a -> b -> c; at c (1, 1); new d = a + (c - b); " + zones +
         " quad a b c d; mirror \"l\"; }";
}

/// The zone of the rule at a match.
AF2FreeZoneDef::Made zoneOf(const LoadedRules& loaded, std::size_t rule, int level,
                            std::vector<Point2> match = {{0, 0}, {1.1, 0}, {1, 1.2}}) {
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  if (!loaded.rules) return {};
  if (rule == 1) match[2].x = match[1].x - match[2].x;
  return loaded.rules->rules()[rule].definition().zone->makeFreeZone({match, level, nullptr});
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at; (at = text.find(from)) != text.npos;) text.replace(at, from.size(), to);
  return text;
}

const std::vector<std::string> kZones = {
    "zone R(c, 0.8) | hull(a, b, c, d);",
    "zone hull(a, b, c, d) & R(mid(a, c), 0.7);",
    "zone hull(a, b, c, d) - R(c, 0.4);",
    "zone R(mid(a, c), 0.9) - hull(b, c, d);",
    "zone (R(a, 1) | R(b, 1)) & (disc(c, 1.1) | R(d, 0.9)) - disc(mid(a, c), 0.2);",
    "zone disc(c, 1) - (R(a, 0.9) | disc(b, 0.5)) | R(d, 0.3) - R(d + (0.2, 0), 0.2);",
    "zone left(a, b - a) & R(mid(a, b), 1.2) & left(c, a - b);",
    "zone (R(c, 1) => R(c, 0.2)) | hull(a, b, c);",
    "zone R(c, 1) when q < 3 and c.x > 0; zone R(a, 1) & R(b, 1) when q < 5; zone hull(a, b, c);",
    "zone R(c, 0.5); zone hull(a, b, c, d); zone R(d, 0.5);"};

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  Point2 point() { return {between(-1, 2.5), between(-1, 2.5)}; }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  std::mt19937 random_;
};

class RegisteredShapes : public ::testing::TestWithParam<std::string> {};

TEST_P(RegisteredShapes, AnswerInCombinationsAsTheLanguagesOwn) {
  const LoadedRules plain = load(quadWith(replaced(GetParam(), "R(", "disc(")));
  const LoadedRules mixed = load(quadWith(replaced(GetParam(), "R(", "round(")));
  const LoadedRules seen = load(quadWith(replaced(GetParam(), "R(", "seen(")));
  Numbers numbers(7);
  for (const std::size_t rule : {0u, 1u})
    for (const int level : {1, 4, 9}) {
      const auto p = zoneOf(plain, rule, level), m = zoneOf(mixed, rule, level),
                 s = zoneOf(seen, rule, level);
      ASSERT_TRUE(p.zone && m.zone && s.zone);
      int inside = 0, met = 0;
      for (int i = 0; i < 1500; ++i) {
        const Point2 u = numbers.point(), v = u + numbers.between(0, 1) * (numbers.point() - u);
        for (const ZoneBoundary boundary : {Counts, Ignored}) {
          EXPECT_EQ(p.zone->contains(u, boundary), m.zone->contains(u, boundary));
          EXPECT_EQ(p.zone->contains(u, boundary), s.zone->contains(u, boundary));
          EXPECT_EQ(p.zone->meets(u, v, boundary), m.zone->meets(u, v, boundary));
        }
        EXPECT_LE(p.zone->meets(u, v, Ignored), s.zone->meets(u, v, Ignored))
            << "nothing is missed";
        inside += p.zone->contains(u, Counts);
        met += p.zone->meets(u, v, Ignored);
        if (!p.zone->contains(u, Counts)) continue;
        const Box2 box = m.zone->boundingBox();
        EXPECT_TRUE(box.low.x <= u.x && u.x <= box.high.x && box.low.y <= u.y && u.y <= box.high.y);
      }
      EXPECT_GT(inside, 10);
      EXPECT_GT(met, inside);
    }
}

TEST_P(RegisteredShapes, CoverWhatTheyHold) {
  const LoadedRules plain = load(quadWith(replaced(GetParam(), "R(", "disc(")));
  const LoadedRules mixed = load(quadWith(replaced(GetParam(), "R(", "round(")));
  const auto p = zoneOf(plain, 0, 1), m = zoneOf(mixed, 0, 1);
  ASSERT_TRUE(p.zone && m.zone);
  Numbers numbers(8);
  for (int i = 0; i < 2000; ++i) {
    const Point2 u = numbers.point(), v = u + numbers.between(0, 0.2) * (numbers.point() - u);
    bool isHeld = true;
    for (int k = 0; k <= 50; ++k)
      isHeld = isHeld && p.zone->contains(u + (k / 50.0) * (v - u), Counts);
    if (covers(*p.zone, u, v)) {
      EXPECT_TRUE(isHeld);
    }
    if (covers(*m.zone, u, v)) {
      EXPECT_TRUE(covers(*p.zone, u, v));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Zones, RegisteredShapes, ::testing::ValuesIn(kZones));

TEST(RegisteredShape, KeepsItsSeamsWithOthersClosedForVertices) {
  const auto made =
      zoneOf(load(quadWith("zone left(a, b - a) & round(a, 2) | hull(a, a - (0, 1), b);")), 0, 1);
  ASSERT_TRUE(made.zone);
  EXPECT_TRUE(made.zone->contains({0.5, 0}, Counts));
  EXPECT_TRUE(made.zone->meets({0.5, -0.1}, {0.5, 0.1}, Ignored));
  EXPECT_FALSE(made.zone->meets({-3, 0}, {-2, 0}, Ignored)) << "it touches from outside";
}

TEST(RegisteredShape, IsRefusedWithWhatItIsPartOf) {
  const LoadedRules rules = load(quadWith("zone hull(a, b, c, d) | round(a, 0 - len(c - b));"));
  const auto made = zoneOf(rules, 0, 1);
  EXPECT_FALSE(made.zone);
  EXPECT_EQ(made.refusal, Refusal::Shape);
  const LoadedRules open = load(quadWith("zone hull(a, b, c, d) | left(a, b - a) - round(a, 1);"));
  EXPECT_EQ(toPretty(open.diagnostics).find("AF2-Z4"), 6u) << toPretty(open.diagnostics);
}

TEST(RegisteredShape, CanBeAskedForAPoint) {
  const LoadedRules rules =
      load(quadWith("require inside(c, round(b, 1.3)), not inside(c, hull(a, b, d) | round(a, "
                    "0.5)); zone a, b, c, d;"));
  ASSERT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  const std::vector<Point2> match{{0, 0}, {1.1, 0}, {1, 1.2}};
  for (const auto& condition : rules.rules->rules()[0].definition().requirements)
    EXPECT_EQ(condition->evaluate({match, 1, nullptr}), 1);
}

TEST(RegisteredShape, CannotBeGrown) {
  const LoadedRules rules =
      load(quadWith("zone hull(a, b, c, d) | grow(hull(a, b) | round(a, 1), 0.1);"));
  EXPECT_FALSE(rules.rules);
  ASSERT_EQ(rules.diagnostics.size(), 1u) << toPretty(rules.diagnostics);
  EXPECT_EQ(idOf(rules.diagnostics[0].code), "Y7");
}

TEST(RegisteredFunction, SaysHowShapesFadeAsItDoesForLists) {
  Registry functions;
  functions.addFunction({"half", "n", 'n', [](std::span<const double> n) {
                           return std::optional<double>(0.5 / n[0]);
                         }});
  LoadOptions options;
  options.registry = &functions;
  const LoadedRules loaded =
      loadRulesFromText("test.af2",
                        "af2 1;\nruleset \"s\" { elements tri; fade half(q); }\nrule \"r\" quality "
                        "1 { new c = mid(a, "
                        "b) + (0, 0.8); zone disc(c, 5) => disc(c, 3); tri a b c; }",
                        options);
  const auto made = zoneOf(loaded, 0, 1, {{0, 0}, {1, 0}});
  ASSERT_TRUE(made.zone);
  const Box2 box = made.zone->boundingBox();
  EXPECT_NEAR(box.high.x - box.low.x, 2 * (0.5 * 5 + 0.5 * 3), 1e-9);
}

/// The engine sees no difference between a shape of the language and the same one registered.
TEST(RegisteredShape, GivesTheSameMesh) {
  const std::string text = R"(
rule "free" quality 1 {
  let  m = mid(a, b);
  new  c = m + (0, 0.866);
  zone R(c, 1.2) & left(a, b - a) | hull(a, b, c) when q < 3;
  zone hull(a, b, c) - R(a, 0.1);
  tri  a b c;
}
rule "seen" quality 1 {
  at   c (0.5, 0.866);
  zone hull(a, b, c) | (R(mid(a, c), 0.4) => R(mid(a, c), 0)) & left(a, b - a);
  tri  a b c;
}
rule "corner" quality 1 { front a -> b -> c; at c (0.5, 0.866); zone hull(a, b, c) & R(b, 3); tri a b c; mirror "left"; }
rule "close" quality 1 { front a -> b -> c -> a; at c (0.5, 0.866) ~ 0.3; zone a, b, c; tri a b c; }
)";
  const FrontInput input = af2::testing::square(.1);
  const auto meshed = [&](const std::string& shape) {
    const LoadedRules loaded = load(replaced(text, "R(", shape + "("));
    EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
    return AF2Algorithm(loaded.rules).execute(af2::testing::FlatMaker(), input, UniformSize(.1));
  };
  const MeshingResult plain = meshed("disc"), mixed = meshed("round");
  EXPECT_EQ(plain.outcome, Outcome::Complete);
  EXPECT_EQ(plain.mesh.vertices, mixed.mesh.vertices);
  EXPECT_EQ(plain.mesh.elements, mixed.mesh.elements);
}

}  // namespace
}  // namespace af2::dsl
