// That finishing by the score lowers the badness of a rule set's own metric and never raises the
// worst one.
#include "engine/optimize/score_finishing.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "engine/optimize/element_badness.h"
#include "tests/support/meshing.h"
#include "tests/support/quad_grid.h"

namespace af2 {
namespace {

using namespace af2::testing;

/// 0 for the half of a unit square, in any order of its corners.
class HalfSquare : public AF2ElementMetric {
 public:
  std::optional<double> badness(std::span<const Point2> c) const override {
    std::array sides{distance(c[0], c[1]), distance(c[1], c[2]), distance(c[2], c[0])};
    std::ranges::sort(sides);
    return std::abs(sides[0] - 1) + std::abs(sides[1] - 1) +
           std::abs(sides[2] / sides[0] - std::sqrt(2.0));
  }
};

/// The same, with the right angle at the second corner only.
class TurnedHalfSquare final : public HalfSquare {
 public:
  std::optional<double> badness(std::span<const Point2> c) const override {
    const Point2 p = c[0] - c[1], q = c[2] - c[1];
    return *HalfSquare::badness(c) + std::abs(dot(p, q)) / (length(p) * length(q));
  }
};

/// Knows no element whose first side is short.
class OfLongSides final : public HalfSquare {
 public:
  std::optional<double> badness(std::span<const Point2> c) const override {
    if (distance(c[0], c[1]) < 0.9) return std::nullopt;
    return HalfSquare::badness(c);
  }
};

/// Knows no element at all.
class Unknown final : public AF2ElementMetric {
 public:
  std::optional<double> badness(std::span<const Point2>) const override { return std::nullopt; }
};

std::shared_ptr<const RuleSet> setWith(std::shared_ptr<const AF2ElementMetric> metric,
                                       Finish finish = Finish::Score,
                                       ChartUnit unit = ChartUnit::WantedLength) {
  RuleSetDefinition definition = triangleSetDefinition();
  definition.metric = std::move(metric);
  definition.finish = finish;
  definition.unit = unit;
  return std::make_shared<RuleSet>(definition);
}

/// A square of n x n unit squares, each cut into two triangles along the same diagonal.
QuadGrid halfSquares(int n) {
  QuadGrid grid(n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) grid.split(i, j);
  return grid;
}

/// Pushes the inner vertices about.
void shake(QuadGrid& grid, double by) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> push(-by, by);
  for (std::size_t v = grid.input.vertexCount; v < grid.mesh.vertices.size(); ++v) {
    SurfacePoint& p = grid.mesh.vertices[v];
    p.position.x = p.u = p.position.x + push(random);
    p.position.y = p.v = p.position.y + push(random);
  }
}

/// Cuts every other square along its other diagonal.
void turnDiagonals(Mesh& mesh, std::size_t squares) {
  for (std::size_t s = 0; s < squares; s += 2) {
    auto& [a, b, c, none] = mesh.elements[s].corners;
    const VertexId d = mesh.elements[squares + s].corners[2];
    mesh.elements[squares + s].corners = {b, c, d, {}};
    c = d;
  }
}

std::vector<double> badnesses(const Mesh& mesh, const RuleSet& rules, double size = 1) {
  const FlatMaker charts;
  const UniformSize sizes(size);
  ElementBadness badness(mesh, rules, charts, sizes);
  std::vector<double> all;
  for (const Element& element : mesh.elements) all.push_back(badness.of(element));
  return all;
}

double worst(const Mesh& mesh, const RuleSet& rules) {
  return std::ranges::max(badnesses(mesh, rules));
}
double mean(const Mesh& mesh, const RuleSet& rules) {
  double sum = 0;
  for (const double badness : badnesses(mesh, rules)) sum += badness;
  return sum / static_cast<double>(mesh.elements.size());
}

OptimizeReport finish(QuadGrid& grid, const RuleSet& rules) {
  const FlatMaker charts;
  const OptimizeReport report =
      finishMesh(grid.mesh, boundaryOf(grid.input), {rules, charts, UniformSize(1)});
  EXPECT_TRUE(report.isSound);
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
  return report;
}

TEST(ScoreFinishing, LeavesIdealElementsExactlyAsTheyAre) {
  const auto metric = std::make_shared<HalfSquare>();
  QuadGrid grid = halfSquares(6);
  turnDiagonals(grid.mesh, 36);
  const Mesh before = grid.mesh;
  const OptimizeReport report = finish(grid, *setWith(metric));
  EXPECT_EQ(report.swaps + report.moves, 0u);
  EXPECT_EQ(grid.mesh, before);

  grid.mesh = before;
  finish(grid, *setWith(metric, Finish::Shape));  // the need for it
  EXPECT_GT(worst(grid.mesh, *setWith(metric)), 0.1);
}

TEST(ScoreFinishing, LowersTheWorstAndTheMeanOfTheMetric) {
  const auto rules = setWith(std::make_shared<HalfSquare>());
  QuadGrid grid = halfSquares(8);
  shake(grid, 0.25);
  const double worstBefore = worst(grid.mesh, *rules), meanBefore = mean(grid.mesh, *rules);
  EXPECT_GT(finish(grid, *rules).moves, 0u);
  EXPECT_LT(worst(grid.mesh, *rules), 0.5 * worstBefore);
  EXPECT_LT(mean(grid.mesh, *rules), 0.5 * meanBefore);
}

TEST(ScoreFinishing, NeverMakesTheWorstElementWorse) {
  for (const double by : {0.05, 0.2, 0.35}) {
    for (const auto& metric : std::initializer_list<std::shared_ptr<const AF2ElementMetric>>{
             std::make_shared<HalfSquare>(), std::make_shared<TurnedHalfSquare>(),
             std::make_shared<ShapeSizeMetric>(10)}) {
      const auto rules = setWith(metric);
      QuadGrid grid = halfSquares(6);
      shake(grid, by);
      turnDiagonals(grid.mesh, 36);
      const double before = worst(grid.mesh, *rules);
      finish(grid, *rules);
      EXPECT_LE(worst(grid.mesh, *rules), before) << by;
    }
  }
}

TEST(ScoreFinishing, SwapsTheDiagonalsOfAKiteAndMarksWhatItChanged) {
  QuadGrid grid = halfSquares(1);
  // A rhombus whose long diagonal is the side between its two triangles.
  const std::array<Point2, 4> rhombus{{{0, 0}, {1, 0.5}, {1.5, 1.5}, {0.5, 1}}};
  for (std::size_t i = 0; i < rhombus.size(); ++i) {
    grid.mesh.vertices[i].position = {rhombus[i].x, rhombus[i].y, 0};
    grid.input.loops[0][i].point = grid.mesh.vertices[i];
  }
  const auto rules = setWith(std::make_shared<ShapeSizeMetric>(10));
  EXPECT_EQ(finish(grid, *rules).swaps, 1u);
  for (const ElementOrigin& origin : grid.mesh.origins) EXPECT_TRUE(origin.isChanged);
  for (const Element& element : grid.mesh.elements)
    EXPECT_EQ(std::ranges::count(element.corners, VertexId(1)), 1);
}

TEST(ScoreFinishing, TurnsANewTriangleSoThatItsMetricIsLeast) {
  const auto rules = setWith(std::make_shared<TurnedHalfSquare>());
  QuadGrid grid(1);  // a square cut into two triangles that begin at a wrong corner
  grid.mesh.elements[0] = {{VertexId(1), VertexId(2), VertexId(0), {}}};
  grid.addElement({{VertexId(2), VertexId(3), VertexId(0), {}}});
  const double before = worst(grid.mesh, *rules);
  EXPECT_GT(before, 0.5);
  EXPECT_EQ(finish(grid, *rules).swaps, 1u);
  EXPECT_NEAR(worst(grid.mesh, *rules), 0, 1e-12);
}

TEST(ScoreFinishing, MakesNoChangeAfterWhichTheMetricHasNoValue) {
  const auto rules = setWith(std::make_shared<OfLongSides>());
  QuadGrid grid = halfSquares(6);
  shake(grid, 0.04);
  ASSERT_TRUE(std::isfinite(worst(grid.mesh, *rules)));
  finish(grid, *rules);
  EXPECT_TRUE(std::isfinite(worst(grid.mesh, *rules)));

  const Mesh before = grid.mesh;
  finish(grid, *setWith(std::make_shared<Unknown>()));
  EXPECT_EQ(grid.mesh, before);
}

TEST(ScoreFinishing, MovesTheVerticesOfQuadrilaterals) {
  const auto rules = setWith(std::make_shared<ShapeSizeMetric>(10));
  QuadGrid grid(6);
  shake(grid, 0.25);
  const double before = worst(grid.mesh, *rules);
  const OptimizeReport report = finish(grid, *rules);
  EXPECT_EQ(report.swaps, 0u);
  EXPECT_LT(worst(grid.mesh, *rules), 0.2 * before);
  for (const ElementOrigin& origin : grid.mesh.origins) EXPECT_FALSE(origin.isChanged);
}

TEST(ScoreFinishing, DoesNothingIfTheRuleSetWantsNothing) {
  QuadGrid grid = halfSquares(4);
  shake(grid, 0.2);
  const Mesh before = grid.mesh;
  finish(grid, *setWith(std::make_shared<HalfSquare>(), Finish::None));
  EXPECT_EQ(grid.mesh, before);
}

TEST(ScoreFinishing, LeavesTheBoundaryAndTheLinesInsideWhereTheyAre) {
  const auto rules = setWith(std::make_shared<ShapeSizeMetric>(10));
  QuadGrid grid = halfSquares(4);
  MeshBoundary boundary = boundaryOf(grid.input);
  const VertexId from = grid.id(1, 1), to = grid.id(2, 2);  // a diagonal that must stay an edge
  boundary.edges.insert(boundary.edges.end(), {{from, to}, {to, from}});
  std::ranges::sort(boundary.edges);
  const FlatMaker charts;
  finishMesh(grid.mesh, boundary, {*rules, charts, UniformSize(1)});
  EXPECT_TRUE(checkMesh(grid.mesh, boundary).empty());
}

TEST(ScoreFinishing, GivesTheSameMeshTwice) {
  const auto rules = setWith(std::make_shared<HalfSquare>());
  QuadGrid one = halfSquares(6);
  shake(one, 0.3);
  QuadGrid other = one;
  finish(one, *rules);
  finish(other, *rules);
  EXPECT_EQ(one.mesh, other.mesh);
}

TEST(ElementBadness, IsMeasuredInTheUnitOfTheRuleSet) {
  const auto metric = std::make_shared<HalfSquare>();
  const QuadGrid grid = halfSquares(2);
  for (const double badness : badnesses(grid.mesh, *setWith(metric), 0.5))
    EXPECT_NEAR(badness, 2, 1e-12);  // both short sides are twice as long as wanted
  const auto byBase = setWith(metric, Finish::Score, ChartUnit::BaseLength);
  EXPECT_NEAR(badnesses(grid.mesh, *byBase, 0.5)[0], 0, 1e-12);
}

}  // namespace
}  // namespace af2
