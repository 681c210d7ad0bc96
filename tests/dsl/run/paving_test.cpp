// Rule sets that keep loops even, on whole regions: quadrilaterals only, welds, rows, columns,
// paths.
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include "dsl/load/rule_file.h"
#include "engine/mesh/element_shape.h"
#include "engine/run/mesh_region.h"
#include "tests/support/meshing.h"
#include "tests/support/random_domain.h"

namespace af2::dsl {
namespace {

using namespace af2::testing;

std::shared_ptr<const RuleSet> paving() {
  static const LoadedRules loaded = loadRules(AF2_SOURCE_DIR "/rules/quad/paving.af2");
  EXPECT_TRUE(loaded.rules && loaded.diagnostics.empty()) << toPretty(loaded.diagnostics);
  return loaded.rules;
}

std::shared_ptr<const RuleSet> rulesOfText(const std::string& text) {
  const LoadedRules loaded = loadRulesFromText("test.af2", text);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  return loaded.rules;
}

std::string pavingText() {
  std::ostringstream text;
  text << std::ifstream(AF2_SOURCE_DIR "/rules/quad/paving.af2").rdbuf();
  return text.str();
}

/// With the elements turned round, but not optimised.
MeshingResult meshWith(const std::shared_ptr<const RuleSet>& rules, const FrontInput& input,
                       double size, AF2MeshingObserver* observer = nullptr) {
  const AF2Algorithm algorithm(rules);
  RegionTask task{
      input,
      [size] {
        return PieceTools{std::make_unique<FlatMaker>(), std::make_unique<UniformSize>(size)};
      },
      nullptr,
      {},
      false,
      0,
      {}};
  FrontOptions options;
  options.observer = observer;
  return meshRegion(algorithm, task, options).result;
}

void expectQuads(const MeshingResult& result, const FrontInput& input) {
  expectGoodMesh(result, input, 0);
  for (const Element& element : result.mesh.elements) EXPECT_TRUE(element.isQuad());
}

FrontInput disc(double size) {
  FrontInput input;
  const int count = 2 * static_cast<int>(3.14159 / size);
  addLoop(input, circle({0, 0}, 1, count, false));
  return input;
}

TEST(Paving, FillsRandomRegionsWithQuadrilateralsAlone) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    const double size = seed % 2 ? 0.05 : 0.1;
    const FrontInput input = randomDomain(seed, size);
    expectQuads(meshWith(paving(), input, size), input);
  }
}

TEST(Paving, MakesGridsOfRectangles) {
  FrontInput input;
  addLoop(input, divided({{0, 0}, {1, 0}, {1, 0.6}, {0, 0.6}}, 0.1));
  const MeshingResult result = meshWith(paving(), input, 0.1);
  expectQuads(result, input);
  EXPECT_EQ(result.mesh.elements.size(), 60u);
  EXPECT_EQ(result.failedSteps, 0u);
}

// Under other names, and without welds, columns and smoothing of rows: nothing depends on them.
TEST(Paving, ClosesEverythingWithRulesThatOnlyAdd) {
  std::string text = pavingText();
  text = std::regex_replace(text, std::regex("  (columns|at +row) [^\n]*\n"), "");
  const std::size_t seam = text.find("rule \"seam\"");
  text.erase(seam, text.find("\n}", seam) + 2 - seam);
  text = std::regex_replace(text, std::regex("\"side\""), "\"along\"");
  text.erase(std::min(text.find("test \""), text.size()));
  const auto rules = rulesOfText(text);
  for (unsigned seed = 0; seed < 16; ++seed) {
    SCOPED_TRACE(seed);
    const FrontInput input = randomDomain(seed, 0.08);
    const MeshingResult result = meshWith(rules, input, 0.08);
    expectQuads(result, input);
    EXPECT_EQ(result.acts.welds + result.acts.columns + result.acts.rows, 0u);
  }
}

TEST(Paving, ChangesTheNumberOfElementsInRowsThatGetShorter) {
  const FrontInput input = disc(0.06);
  const MeshingResult result = meshWith(paving(), input, 0.06);
  expectQuads(result, input);
  EXPECT_GT(result.acts.rows, 3u);
  EXPECT_GT(result.acts.moves, 100u);
  EXPECT_GT(result.acts.columns, 3u);
  // Without them, the rows inside have as many elements as the boundary.
  const std::string text = std::regex_replace(pavingText(), std::regex("  columns [^\n]*\n"), "");
  const MeshingResult other = meshWith(rulesOfText(text), input, 0.06);
  EXPECT_LT(result.mesh.elements.size(), other.mesh.elements.size());
}

/// Counts what it hears of.
class Acts final : public AF2MeshingObserver {
 public:
  void frontActed(const FrontAct& act, const Mesh&) override {
    welds += act.kind == FrontAct::Kind::Weld;
    rows += act.kind == FrontAct::Kind::Row;
    columns += act.kind == FrontAct::Kind::Columns ? act.count : 0;
    paths += act.kind == FrontAct::Kind::Path;
  }
  std::size_t welds = 0, rows = 0, columns = 0, paths = 0;
};

TEST(Paving, WeldsAndLeavesNoVertexWithoutElements) {
  std::size_t welds = 0;
  for (unsigned seed = 0; seed < 24; ++seed) {
    const FrontInput input = randomDomain(seed, 0.04);
    Acts heard;
    const MeshingResult result = meshWith(paving(), input, 0.04, &heard);
    expectQuads(result, input);
    EXPECT_EQ(heard.welds, result.acts.welds);
    EXPECT_EQ(heard.rows, result.acts.rows);
    EXPECT_EQ(heard.columns, result.acts.columns);
    welds += result.acts.welds;
    std::vector<bool> isUsed(result.mesh.vertices.size(), false);
    for (const Element& element : result.mesh.elements)
      for (const VertexId v : element.vertices()) isUsed[v.value] = true;
    EXPECT_TRUE(std::ranges::all_of(isUsed, std::identity()));
  }
  EXPECT_GT(welds, 0u);
}

TEST(Paving, GivesTheSameMeshAgain) {
  const FrontInput input = randomDomain(3, 0.05);
  expectEqualResults(meshWith(paving(), input, 0.05), meshWith(paving(), input, 0.05));
}

// Rows with edges of 0.38 and of 1.6 meet along the whole length, and hundreds of elements have to
// be turned round, many of them beside each other.
TEST(Paving, FillsLongStripsWithAFineAndACoarseSide) {
  std::vector<Point2> outline;
  constexpr double kLength = 300, kWidth = 4.7;
  for (int i = 0; i < 786; ++i) outline.push_back({i * kLength / 786, 0});
  for (const double y : {0., .46, 1.08, 1.91, 3.01, 3.98}) outline.push_back({kLength, y});
  for (int i = 186; i > 0; --i) outline.push_back({i * kLength / 186, kWidth});
  for (const double y : {4.7, 3.98, 3.01, 1.91, 1.08, .46}) outline.push_back({0, y});
  FrontInput input;
  addLoop(input, outline);
  expectQuads(meshWith(paving(), input, 1), input);
}

/// Rows from the straight sides meet those around the arc at a slant, along a line of a hundred
/// edges.
TEST(Paving, MeetsAtASlantWithoutLongEdges) {
  constexpr double kSize = 0.001, kRadius = 0.2;
  std::vector<Point2> outline =
      divided({{0.3, 0.5}, {0.25, 0.5}, {0.25, 0.25}, {0.5, 0.25}, {0.5, 0.3}}, kSize);
  // Without what closed the polygon, which becomes an arc.
  std::erase_if(outline, [](Point2 p) { return p.x > 0.3 && p.y > 0.3; });
  const int parts = static_cast<int>(std::lround(M_PI / 2 * kRadius / kSize));
  for (int i = 1; i < parts; ++i) {
    const double t = M_PI / 2 * (3 - static_cast<double>(i) / parts);
    outline.push_back(Point2{0.5, 0.5} + kRadius * Point2{std::cos(t), std::sin(t)});
  }
  FrontInput input;
  addLoop(input, outline);
  ASSERT_EQ(input.vertexCount % 2, 0u);
  const MeshingResult result = meshWith(paving(), input, kSize);
  expectQuads(result, input);
  double longest = 0;
  for (const Element& element : result.mesh.elements) {
    const auto corners = element.vertices();
    for (std::size_t i = 0; i < 4; ++i)
      longest =
          std::max(longest, distance(result.mesh.vertices[corners[i].value].position,
                                     result.mesh.vertices[corners[(i + 1) % 4].value].position));
  }
  EXPECT_LT(longest, 3 * kSize);
}

// A single odd loop cannot be filled with quadrilaterals: the front stops, and says so.
TEST(Paving, LeavesAFewEdgesOfAnOddLoopAndSoundElements) {
  FrontInput input;
  addLoop(input, circle({0, 0}, 1, 31, false));
  const MeshingResult result = meshWith(paving(), input, 0.2);
  EXPECT_EQ(result.outcome, Outcome::Stuck);
  EXPECT_LE(result.stuck.size(), 7u);
  EXPECT_EQ(result.stuck.size() % 2, 1u);
  for (const Element& element : result.mesh.elements) EXPECT_FALSE(leans(result.mesh, element));
}

// Loops of three edges remain, which must not be turned inside out while rows are smoothed: the
// front would go on outside the region.
TEST(Paving, LeavesAFewEdgesOfTwoOddLoops) {
  constexpr double kSize = 0.05;
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const double outer = 0.6 + 0.03 * i, inner = outer * (0.1 + 0.006 * i);
    const auto odd = [](double radius) { return static_cast<int>(2 * M_PI * radius / kSize) | 1; };
    FrontInput input;
    addLoop(input, circle({0, 0}, outer, odd(outer), false));
    addLoop(input, circle({0.02 * i, 0}, inner, odd(inner), true));
    const MeshingResult result = meshWith(paving(), input, kSize);
    EXPECT_LE(result.stuck.size(), 16u);
    EXPECT_LT(areaOf(result.mesh), areaOf(input) + 1e-9);
  }
}

// The last level closes with a quadrilateral that has a straight corner. Between given edges only
// more elements mend it.
TEST(Paving, DividesALastQuadrilateralWithAStraightCorner) {
  FrontInput input;
  addLoop(input, {{0, 0}, {0.5, 0}, {1, 0}, {0, 1}});
  const MeshingResult result = meshWith(paving(), input, 0.7);
  expectQuads(result, input);
  EXPECT_EQ(result.mesh.elements.size(), 5u);
}

// The tips are too sharp for that: the front must be left open, not spoil the mesh.
TEST(Paving, LeavesOpenWhatCannotBeTurnedRound) {
  FrontInput input;
  addLoop(input, {{0, 0}, {1, 0.1}, {2, 0}, {1, 0.15}});
  const MeshingResult result = meshWith(paving(), input, 1);
  EXPECT_EQ(result.outcome, Outcome::Stuck);
  EXPECT_FALSE(result.stuck.empty());
}

const std::string kPath = R"(af2 1;
ruleset "paths" { elements quad; parity even; score max of jacobian_badness; classes 1..2; }
rule "four" quality 1 {
  front a -> b -> c -> d -> a;
  at    c (1, 1) ~ any, d (0, 1) ~ any;
  zone  poly(a, b, c, d);
  quad  a b c d;
}
rule "bridge" quality 1 {
  far     c;
  require dist(a, c) < 2.6;
  path    a -> c by dist(a, c);
  cost    abs(dist(a, c) - 1);
}
)";

TEST(Paths, DivideLoopsUntilTheRulesCloseThem) {
  FrontInput input;
  addLoop(input, divided({{0, 0}, {4, 0}, {4, 2}, {0, 2}}, 1));
  Acts heard;
  const MeshingResult result = meshWith(rulesOfText(kPath), input, 1, &heard);
  expectQuads(result, input);
  EXPECT_GT(result.acts.paths, 0u);
  EXPECT_EQ(heard.paths, result.acts.paths);
}

TEST(Paths, AreNotLaidWhereNoneIsAllowed) {
  FrontInput input;
  addLoop(input, divided({{0, 0}, {4, 0}, {4, 2}, {0, 2}}, 1));
  std::string text = kPath;
  text.replace(text.find("< 2.6"), 5, "in 2.5..2.6");
  const MeshingResult result = meshWith(rulesOfText(text), input, 1);
  EXPECT_EQ(result.outcome, Outcome::Stuck);
  EXPECT_EQ(result.acts.paths, 0u);
  EXPECT_EQ(result.stuck.size(), 12u);
}

// A rule whose edges would join like colours is refused for that reason, and the others go on.
TEST(Parity, IsTheReasonOfARefusal) {
  const auto rules = rulesOfText(R"(af2 1;
ruleset "even" { elements quad; parity even; score max of jacobian_badness; }
rule "to the point" quality 1 {
  at     c (1, 1);
  new    d = a + (c - b);
  zone   a, b, c, d;
  quad   a b c d;
  mirror "to the point, left";
}
)");
  FrontPiece piece;
  // Around a square of three by one and back above: from b to (1, 1) there are five edges.
  piece.vertices = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0.5, 2.6}};
  piece.chains = {{0, 1, 2, 3, 4, 5, 6, 7}};
  piece.base = {0, 1};
  const SingleStep even = takeSingleStep(*rules, piece);
  ASSERT_TRUE(even.rule);
  piece.vertices.insert(piece.vertices.begin() + 4, {3.5, 0.5});
  piece.chains = {{0, 1, 2, 3, 4, 5, 6, 7, 8}};
  const SingleStep odd = takeSingleStep(*rules, piece);
  EXPECT_FALSE(odd.rule);
  EXPECT_EQ(odd.refusals[0].reason, Refusal::Parity);
}

}  // namespace
}  // namespace af2::dsl
