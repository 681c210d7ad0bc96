// Whole meshes of flat regions with rules from text: what only the engine's loop can show.
#include <gtest/gtest.h>

#include "dsl/load/rule_file.h"
#include "engine/mesh/element_shape.h"
#include "engine/optimize/optimize.h"
#include "engine/run/mesh_region.h"
#include "tests/support/meshing.h"

namespace af2::dsl {
namespace {

using namespace af2::testing;

std::shared_ptr<const RuleSet> rulesFrom(const std::string& text) {
  const LoadedRules loaded = loadRulesFromText("test.af2", "af2 1;\n" + text);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  return loaded.rules;
}

MeshingResult mesh(const std::shared_ptr<const RuleSet>& rules, const FrontInput& input,
                   double size) {
  return AF2Algorithm(rules).execute(FlatMaker(), input, UniformSize(size));
}

FrontInput rectangle(double width, double height, double size) {
  FrontInput input;
  addLoop(input, divided({{0, 0}, {width, 0}, {width, height}, {0, height}}, size));
  return input;
}

std::size_t quadCount(const Mesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                                [](const Element& e) { return e.isQuad(); }));
}

double worstDistortion(const Mesh& mesh) {
  double worst = 0;
  for (const Element& element : mesh.elements) {
    std::vector<const SurfacePoint*> corners;
    for (const VertexId v : element.vertices()) corners.push_back(&mesh.vertices[v.value]);
    worst = std::max(worst, elementDistortion(corners));
  }
  return worst;
}

int sharedCorners(const Element& one, const Element& other) {
  int count = 0;
  for (VertexId v : one.corners)
    count += !v.isNone() && std::count(other.corners.begin(), other.corners.end(), v) > 0;
  return count;
}

/// Fills a rectangle with unit squares, row after row.
const std::string kGrid = R"(
rule "next" quality 1 {
  front d -> a -> b;
  at    d (0, 1);
  new   c = d + (b - a);
  zone  a, b, lerp(b, c, 1.3) => c, lerp(a, d, 1.3) => d, d;
  quad  a b c d;
  mirror "next, left";
}
rule "last" quality 1 {
  front d -> a -> b -> c;
  at    d (0, 1), c (1, 1);
  zone  a, b, c, d;
  quad  a b c d;
}
)";
const std::string kClose = R"(
rule "close" quality 1 {
  front a -> b -> c -> d -> a;
  at    d (0, 1), c (1, 1);
  zone  a, b, c, d;
  quad  a b c d;
}
)";
const std::string kQuads = "ruleset \"grid\" { elements quad; score max of jacobian_badness; ";

// The new vertex of "next" is a corner of its zone: where rounding had put the vertex that stands
// there already a hair outside of the zone, a second one was made beside it.
TEST(RuleMeshes, SeeAVertexAtTheVeryPlaceOfANewOne) {
  for (const char* order : {"", "front rows;"}) {
    const auto rules = rulesFrom(kQuads + order + "}" + kGrid + kClose);
    for (double size : {0.2, 0.1, 0.05, 1.0 / 13}) {
      const FrontInput input = rectangle(1, 1, size);
      const MeshingResult result = mesh(rules, input, size);
      expectGoodMesh(result, input, 0);
      EXPECT_NEAR(static_cast<double>(result.mesh.elements.size()), 1 / (size * size), 1e-6);
    }
  }
}

TEST(RuleMeshes, RowsGoEdgeAfterEdgeAroundTheLoop) {
  const auto rules = rulesFrom(kQuads + "front rows(start: smallest_turn); }" + kGrid + kClose);
  const FrontInput input = rectangle(9, 7, 1);
  const MeshingResult result = mesh(rules, input, 1);
  expectGoodMesh(result, input, 0);
  const auto& elements = result.mesh.elements;
  // Rows of 28, 20, 12 and 3 squares. Each is beside the one before, and the last closes the row.
  std::size_t first = 0;
  for (std::size_t count : {28u, 20u, 12u}) {
    for (std::size_t i = first + 1; i < first + count; ++i)
      EXPECT_EQ(sharedCorners(elements[i - 1], elements[i]), 2) << i;
    EXPECT_EQ(sharedCorners(elements[first], elements[first + count - 1]), 2) << first;
    first += count;
  }
  ASSERT_EQ(elements.size(), first + 3);
}

TEST(RuleMeshes, QuadsInRowsFillRegionsWithHolesAndCorners) {
  const LoadedRules rules = loadRules(AF2_SOURCE_DIR "/rules/quad/rows.af2");
  ASSERT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  FrontInput plate = rectangle(10, 6, 0.25);
  addLoop(plate, circle({3, 3}, 1.5, 38, true));
  FrontInput shape;
  addLoop(shape, divided({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0.1));
  for (const auto& [input, size] : {std::pair{plate, 0.25}, {shape, 0.1}}) {
    const MeshingResult result = mesh(rules.rules, input, size);
    expectGoodMesh(result, input, 0);
    EXPECT_GE(static_cast<double>(quadCount(result.mesh)),
              0.9 * static_cast<double>(result.mesh.elements.size()));
  }
}

TEST(RuleMeshes, QuadsAreTidiedWhereFrontsCollide) {
  const LoadedRules rules = loadRules(AF2_SOURCE_DIR "/rules/quad/classic.af2");
  ASSERT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  FrontInput plate = rectangle(10, 6, 0.25);
  addLoop(plate, circle({3, 3}, 1.5, 38, true));
  for (const auto& [input, size] : {std::pair{plate, 0.25}, {discWithHole(.03), .03}}) {
    MeshingResult result = mesh(rules.rules, input, size);
    const double raw = worstDistortion(result.mesh);
    const auto triangles = [&] { return result.mesh.elements.size() - quadCount(result.mesh); };
    const std::size_t rawTriangles = triangles();
    EXPECT_GT(optimizeMesh(result.mesh, boundaryOf(input), FlatMaker()).replacements, 0u);
    expectGoodMesh(result, input, 0);
    EXPECT_LT(worstDistortion(result.mesh), std::min(raw, 2.0));
    EXPECT_LE(triangles(), rawTriangles);
  }
}

TEST(RuleMeshes, QuadsFillARegionInPieces) {
  const LoadedRules rules = loadRules(AF2_SOURCE_DIR "/rules/quad/classic.af2");
  ASSERT_TRUE(rules.rules) << toPretty(rules.diagnostics);
  FrontInput plate = rectangle(4, 3, 0.04);
  for (const Point2 center : {Point2{1, 1}, {2.2, 1.9}, {3.1, 0.8}})
    addLoop(plate, circle(center, 0.4, 53, true));
  const FlatPoints plane;
  const auto tools = [] {
    return PieceTools{std::make_unique<FlatMaker>(), std::make_shared<UniformSize>(.04)};
  };
  std::optional<Mesh> first;
  for (const int threads : {1, 3}) {
    const RegionMesh region =
        meshRegion(AF2Algorithm(rules.rules), {plate, tools, &plane, {500}, true, threads}, {});
    EXPECT_EQ(region.fault, "");
    expectGoodMesh(region.result, plate, 0);
    EXPECT_LT(worstDistortion(region.result.mesh), 3);
    if (!first) first = region.result.mesh;
    EXPECT_EQ(region.result.mesh, *first);
  }
}

// The square in the middle of 3 x 3: what surrounds it is known.
TEST(RuleMeshes, RulesKnowTheirSurroundings) {
  const std::string middle = R"(
rule "middle" quality 1 {
  front   a -> b -> c -> d -> a;
  at      d (0, 1), c (1, 1);
  require WHAT;
  zone    a, b, c, d;
  quad    a b c d;
  cost    -1;
})";
  // "last" can do it, too, but at a higher cost.
  const auto holds = [&](const std::string& what) {
    std::string rule = middle;
    rule.replace(rule.find("WHAT"), 4, what);
    const FrontInput input = rectangle(3, 3, 1);
    const MeshingResult result = mesh(rulesFrom(kQuads + "}" + kGrid + rule), input, 1);
    EXPECT_EQ(result.mesh.elements.size(), 9u);
    return result.mesh.origins.back().rule == 3;
  };
  EXPECT_TRUE(holds("layer(a) == 1, layer(c) == 1, not on_boundary(b)"));
  EXPECT_TRUE(holds("valence(a) == 3, valence(b) == 3, valence(c) == 3, valence(d) == 3"));
  EXPECT_TRUE(holds("loop_size() == 4"));
  EXPECT_TRUE(holds("abs(dist_front(centroid(a, b, c, d)) - 0.5) < 1e-12"));
  EXPECT_TRUE(holds("dist_front(mid(c, d)) == 0"));
  EXPECT_TRUE(holds("h(a) == 1, h(mid(a, c)) == 1, curvature(mid(a, c)) == 0"));
  EXPECT_TRUE(holds("abs(turn(a) / 90deg - 1) < 1e-12, abs(turn(c) / 90deg - 1) < 1e-12"));
  EXPECT_FALSE(holds("loop_size() != 4"));
  EXPECT_FALSE(holds("layer(a) == 0 or on_boundary(c)"));
  EXPECT_FALSE(holds("valence(c) != 3"));
}

TEST(RuleMeshes, LoopSizeFollowsTheFrontAsItShrinksAndSplits) {
  // A hexagon: an ear is cut while six edges are left, then while five, then four, then the rest.
  for (const auto& [bound, isPossible] : {std::pair{"> 3", true}, {"> 4", false}}) {
    const auto rules = rulesFrom(std::string(R"(
ruleset "ears" { elements tri; }
rule "ear" quality 1 {
  front   a -> b -> c;
  at      c (1.5, 0.866) ~ any;
  require loop_size() )") + bound +
                                 R"(;
  zone    a, b, c;
  tri     a b c;
}
rule "last" quality 1 {
  front   a -> b -> c -> a;
  at      c (0.5, 0.866) ~ any;
  require loop_size() == 3;
  zone    a, b, c;
  tri     a b c;
})");
    FrontInput input;
    addLoop(input, circle({0, 0}, 1, 6));
    EXPECT_EQ(mesh(rules, input, 1).outcome == Outcome::Complete, isPossible) << bound;
  }
}

// Only the rule's own zone used to be looked at, which is much smaller than this.
TEST(RuleMeshes, TheDistanceToTheFrontIsKnownFarFromTheBase) {
  const auto rules = rulesFrom(R"(
ruleset "far" { elements tri; }
rule "far" quality 1 {
  new     c = mid(a, b) + (0, 0.1);
  require abs(dist_front(mid(a, b) + (0, 7)) - 2) < 1e-12;
  zone    a, b, c;
  tri     a b c;
})");
  FrontInput input;
  addLoop(input, {{0, 0}, {1, 0}, {9, 1}, {9, 12}, {-8, 12}, {-8, 1}});
  addLoop(input, {{0.4, 5}, {0.5, 5}, {0.6, 5}, {0.5, 4.9}});
  EXPECT_GT(mesh(rules, input, 1).mesh.elements.size(), 0u);
}

TEST(RuleMeshes, TolerancesAndScoresMayGoByLevel) {
  // One quadrilateral, sheared by 0.5: a tolerance of 8/q admits it from level 4 on, a metric that
  // starts at 4 from the same one; the vertices are found by a chain, and by looking around.
  FrontInput input;
  addLoop(input, {{0, 0}, {1, 0}, {1.5, 1}, {0.5, 1}});
  const std::string metric =
      "metric later(u, v, w, x) = max(0, 4 - q) + 0.1 * jacobian_badness(u, v, w, x);\n";
  const auto rules = [&](const char* set, const char* front, const char* tolerance, int levels) {
    return rulesFrom(metric + "ruleset \"levels\" { elements quad; match 0.5; score max of " + set +
                     "; accept score < 1; classes 1.." + std::to_string(levels) +
                     "; }\nrule \"whole\" quality 1 { front " + front + "; at c (1, 1) ~ " +
                     tolerance + ", d (0, 1) ~ " + tolerance +
                     "; zone a, b, c, d; quad a b c d; meta { allow \"D4\"; } }");
  };
  const char* const loop = "a -> b -> c -> d -> a";
  const char* const apart = "a -> b, c -> d";
  for (const auto& [set, front, tolerance] : {std::tuple{"jacobian_badness", loop, "8 / q"},
                                              {"jacobian_badness", apart, "8 / q"},
                                              {"later", loop, "any"},
                                              {"later", apart, "1"}}) {
    EXPECT_EQ(mesh(rules(set, front, tolerance, 3), input, 1).mesh.elements.size(), 0u)
        << set << " " << front << " " << tolerance;
    EXPECT_EQ(mesh(rules(set, front, tolerance, 4), input, 1).mesh.elements.size(), 1u)
        << set << " " << front << " " << tolerance;
  }
}

TEST(RuleMeshes, SizesAreInTheUnitOfTheFrame) {
  // The wanted length is 0.5 at x = 0 and 1 at x = 2; the frame of the base has their mean, 0.75.
  class Growing final : public SizeField {
   public:
    double sizeAt(const SurfacePoint& p) const override { return 0.5 + 0.25 * p.position.x; }
  };
  const auto rules = rulesFrom(R"(
ruleset "sizes" { elements quad; score max of jacobian_badness; }
rule "whole" quality 1 {
  front   a -> b -> c -> d -> a;
  at      c (1, 1) ~ any, d (0, 1) ~ any;
  require abs(h(a) - 0.5/0.75) < 1e-12, abs(h(b) - 1/0.75) < 1e-12, abs(b.x - 2/0.75) < 1e-12;
  zone    a, b, c, d;
  quad    a b c d;
  meta    { allow "D4"; }
})");
  FrontInput input;
  addLoop(input, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  const MeshingResult result = AF2Algorithm(rules).execute(FlatMaker(), input, Growing());
  EXPECT_EQ(result.outcome, Outcome::Complete);
}

/// The classical rules and one more, which comes first wherever it fits.
std::shared_ptr<const RuleSet> classicWith(const std::string& rule) {
  LoadOptions options;
  options.searchPaths = {AF2_SOURCE_DIR "/rules"};
  const LoadedRules loaded = loadRulesFromText(
      "test.af2",
      "af2 1;\nimport \"tri/classic.af2\" as classic;\nuse classic.*;\n"
      "ruleset \"test\" { elements tri; match 0.5 + 0.3*q; score max of shape_size(10);"
      " accept score < 2 + 0.5*q^2; front by q + layer(a) + layer(b); }\n" +
          rule,
      options);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  return loaded.rules;
}

std::size_t elementsOf(const std::string& rule, const MeshingResult& result, const RuleSet& rules) {
  return static_cast<std::size_t>(std::ranges::count_if(
      result.mesh.origins,
      [&](const ElementOrigin& origin) { return rules.rules()[origin.rule].name() == rule; }));
}

// Where new elements touched in a matched vertex, the front was linked wrongly there, crossed its
// boundary and grew without end.
TEST(RuleMeshes, HoldElementsOfOneStepThatTouchInAVertexOfTheFront) {
  const std::string teeth = R"(
rule "touching" quality 1 {
  front a -> b -> c;
  at    c (2, 0);
  new   p = mid(a, b) + (0, 0.866), r = mid(b, c) + (0, 0.866);
  zone  a, a + (0.2, -0.6), c + (-0.2, -0.6), c, 2*r - b, 2*p - b;
  tri   a b p, b c r;
  cost  -1;
}
)",
                    notches = R"(
rule "touching" quality 1 {
  front a -> b -> c -> d -> e;
  at    c (1.5, 0.866), d (2.5, 0.866), e (3, 1.732);
  new   p = a + (c - b), r = c + (e - d);
  zone  a, b + (0.2, -0.5), d + (0.2, -0.5), e, 2*r - c, 2*r - d, 2*p - b, 2*p - c;
  tri   a b p, b c p, c d r, d e r;
  cost  -1;
}
)";
  for (const std::string& rule : {teeth, notches}) {
    const auto rules = classicWith(rule);
    for (const double size : {0.05, 0.02}) {
      const FrontInput input = discWithHole(size);
      const MeshingResult result = mesh(rules, input, size);
      expectGoodMesh(result, input, 0);
      EXPECT_GT(elementsOf("touching", result, *rules), 10u) << rule;
    }
  }
}

TEST(RuleMeshes, HoldElementsOfOneStepThatTouchInAVertexInside) {
  const auto rules = classicWith(R"(
rule "hourglass" quality 1 {
  at   c (0.5, 0.866);
  new  p = 2*c - b, s = 2*c - a;
  zone a, b, s + (0.2, 0), s + (0, 0.2), p + (0, 0.2), p - (0.2, 0);
  tri  a b c, c s p;
  cost -1;
}
)");
  FrontInput input = square(0.1);
  input.isolated.push_back(flatCorner(input.vertexCount++, {0.45, 0.0866}));
  const MeshingResult result = mesh(rules, input, 0.1);
  expectGoodMesh(result, input, 0);
  EXPECT_EQ(elementsOf("hourglass", result, *rules), 2u);
}

}  // namespace
}  // namespace af2::dsl
