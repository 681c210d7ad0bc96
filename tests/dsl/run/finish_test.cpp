// What `finish` of a rule set does to whole meshes.
#include <gtest/gtest.h>

#include <algorithm>

#include "dsl/load/rule_file.h"
#include "engine/optimize/element_badness.h"
#include "engine/optimize/finish_mesh.h"
#include "engine/run/mesh_region.h"
#include "tests/support/meshing.h"

namespace af2::dsl {
namespace {

using namespace af2::testing;

/// Fills a rectangle with halves of squares.
const std::string kHalfSquares = R"(
def shortest(u, v, w) = min(dist(u, v), dist(v, w), dist(w, u));
def longest(u, v, w) = max(dist(u, v), dist(v, w), dist(w, u));
metric half_square(u, v, w) = abs(longest(u, v, w) / shortest(u, v, w) - sqrt(2))
  + (dist(u, v) + dist(v, w) + dist(w, u) - longest(u, v, w)) / shortest(u, v, w) - 2;
rule "next" quality 1 {
  front d -> a -> b;
  at    d (0, 1);
  new   c = d + (b - a);
  zone  a, b, lerp(b, c, 1.3) => c, lerp(a, d, 1.3) => d, d;
  tri   a b c, a c d;
  mirror "next, left";
}
rule "last" quality 1 {
  front d -> a -> b -> c;
  at    d (0, 1), c (1, 1);
  zone  a, b, c, d;
  tri   a b c, a c d;
}
rule "close" quality 1 {
  front a -> b -> c -> d -> a;
  at    d (0, 1), c (1, 1);
  zone  a, b, c, d;
  tri   a b c, a c d;
}
)";

std::shared_ptr<const RuleSet> halfSquares(const std::string& finish) {
  const LoadedRules loaded = loadRulesFromText(
      "test.af2", "af2 1;" + kHalfSquares +
                      "ruleset \"s\" { elements tri; score max of half_square; " + finish + " }");
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  return loaded.rules;
}

FrontInput plate(double size) {
  FrontInput input;
  addLoop(input, divided({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, size));
  return input;
}

RegionMesh meshed(const std::shared_ptr<const RuleSet>& rules, const FrontInput& input, double size,
                  bool optimize = true, int threads = 1) {
  static const FlatPoints plane;
  const auto tools = [&] {
    return PieceTools{std::make_unique<FlatMaker>(), std::make_shared<UniformSize>(size)};
  };
  return meshRegion(AF2Algorithm(rules), {input, tools, &plane, {500}, optimize, threads}, {});
}

double worst(const Mesh& mesh, const RuleSet& rules, double size) {
  const FlatMaker charts;
  const UniformSize sizes(size);
  ElementBadness badness(mesh, rules, charts, sizes);
  double result = 0;
  for (const Element& element : mesh.elements) result = std::max(result, badness.of(element));
  return result;
}

TEST(Finish, ScoreKeepsAnExactMeshThatShapeMakesWorse) {
  const FrontInput input = plate(0.25);
  const auto byScore = halfSquares("finish score;");
  const Mesh asMade = meshed(byScore, input, 0.25, false).result.mesh;
  EXPECT_EQ(asMade.elements.size(), 64u);
  EXPECT_NEAR(worst(asMade, *byScore, 0.25), 0, 1e-9);
  EXPECT_EQ(meshed(byScore, input, 0.25).result.mesh, asMade);
  for (const char* finish : {"finish shape;", ""}) {
    const Mesh byShape = meshed(halfSquares(finish), input, 0.25).result.mesh;
    EXPECT_GT(worst(byShape, *byScore, 0.25), 0.05) << finish;
  }
}

TEST(Finish, NoneGivesTheMeshOfTheFront) {
  for (const double size : {0.25, 0.04}) {  // the smaller one in pieces
    const FrontInput input = plate(size);
    const RegionMesh none = meshed(halfSquares("finish none;"), input, size);
    EXPECT_EQ(none.result.mesh, meshed(halfSquares(""), input, size, false).result.mesh);
    EXPECT_EQ(none.fault, "");
  }
}

TEST(Finish, ScoreGivesTheSameMeshOnAnyNumberOfThreads) {
  FrontInput input = plate(0.03);
  addLoop(input, circle({1, 0.5}, 0.2, 42, true));
  LoadedRules loaded = loadRules(AF2_SOURCE_DIR "/rules/tri/classic.af2");
  ASSERT_TRUE(loaded.rules);
  RuleSetDefinition definition = loaded.rules->definition();
  definition.finish = Finish::Score;
  const auto rules = std::make_shared<const RuleSet>(definition);
  const Mesh asMade = meshed(rules, input, 0.03, false).result.mesh;
  const RegionMesh one = meshed(rules, input, 0.03, true, 1),
                   two = meshed(rules, input, 0.03, true, 2);
  EXPECT_EQ(one.result.mesh, two.result.mesh);
  expectGoodMesh(one.result, input, 0.3);
  EXPECT_LE(worst(one.result.mesh, *rules, 0.03), worst(asMade, *rules, 0.03));
}

TEST(Finish, IsInheritedAndReplaced) {
  const std::string base = "ruleset \"s\" { elements tri; finish none; }" + kHalfSquares;
  const auto finishOf = [&](const std::string& more) {
    const LoadedRules loaded = loadRulesFromText(
        "test.af2", "af2 1; " + base + "ruleset \"t\" extends \"s\" {" + more + "}");
    EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
    return loaded.rules->definition().finish;
  };
  EXPECT_EQ(finishOf(""), Finish::None);
  EXPECT_EQ(finishOf("finish score;"), Finish::Score);
}

TEST(Finish, UnknownWordsAreReportedWithTheOnesThatThereAre) {
  const LoadedRules loaded = loadRulesFromText(
      "test.af2", "af2 1; ruleset \"s\" { finish best; finish none; }" + kHalfSquares);
  EXPECT_FALSE(loaded.rules);
  ASSERT_FALSE(loaded.diagnostics.empty());
  EXPECT_EQ(loaded.diagnostics[0].message, "expected shape, score or none, found 'best'");
}

}  // namespace
}  // namespace af2::dsl
