// Regions cut into pieces: that the pieces fit together, and that threads change nothing.
#include "engine/run/mesh_region.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numbers>

#include "tests/support/meshing.h"

namespace af2 {
namespace {

using namespace af2::testing;

const FlatPoints kPlane;

RegionMesh meshIn(const FrontInput& input, double size, double pieceElements, int threads,
                  const FrontOptions& options = {}) {
  const auto tools = [&] {
    return PieceTools{std::make_unique<FlatMaker>(), std::make_shared<UniformSize>(size)};
  };
  return meshRegion(AF2Algorithm(triangleSet()),
                    {input, tools, &kPlane, {pieceElements}, true, threads}, options);
}

FrontInput comb() {
  FrontInput input;
  std::vector<Point2> outline{{0, 0}, {9, 0}};
  for (int i = 4; i >= 0; --i) {
    outline.push_back({2.0 * i + 1, 4});
    outline.push_back({2.0 * i, 4});
    if (i > 0) outline.insert(outline.end(), {{2.0 * i, 1}, {2.0 * i - 1, 1}});
  }
  addLoop(input, divided(outline, .1));
  return input;
}

FrontInput manyHoles() {
  FrontInput input;
  addLoop(input, divided({{0, 0}, {6, 0}, {6, 4}, {0, 4}}, .1));
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 3; ++j) addLoop(input, circle({1.0 + i, 1.0 + j}, .25, 16, true));
  return input;
}

/// Charts in the plane, of which some lead astray: those from the `first` on that is asked for, to
/// before the `last`.
class AstrayMaker final : public AF2LocalTransformMaker {
 public:
  AstrayMaker(int first, int last) : first_(first), last_(last) {}
  std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double unit) const override {
    const int asked = asked_++;
    if (asked < first_ || asked >= last_) return FlatMaker().makeLocalTransform(from, to, unit);
    return std::make_unique<Astray>(from, to, unit);
  }

 private:
  /// A plane chart that leads back to a place three units off.
  struct Astray final : AF2LocalTransform {
    Astray(const SurfacePoint& from, const SurfacePoint& to, double unit)
        : chart(from, to, {0, 0, 1}, unit) {}
    ChartPoint transformFromSurface(const SurfacePoint& p) const override {
      return chart.transformFromSurface(p);
    }
    std::optional<SurfacePoint> transformToSurface(Point2 p) const override {
      return chart.transformToSurface(p + Point2{3, 0});
    }
    const ProjectionFrame* projection() const override { return chart.projection(); }
    PlaneChart chart;
  };
  int first_, last_;
  mutable int asked_ = 0;
};

TEST(MeshRegion, MakesTheMeshAnewThatTheOptimiserSpoils) {
  const FrontInput input = discWithHole(.05);
  const AF2Algorithm algorithm(triangleSet());
  const auto size = std::make_shared<UniformSize>(.05);
  const MeshingResult raw = algorithm.execute(FlatMaker(), input, *size);
  const auto meshWith = [&](int first, int last) {
    const auto tools = [&] { return PieceTools{std::make_unique<AstrayMaker>(first, last), size}; };
    return meshRegion(algorithm, {input, tools}, {}).result;
  };
  const int charts = static_cast<int>(raw.steps);  // of the front
  EXPECT_NE(meshWith(charts, charts).mesh, raw.mesh);
  const MeshingResult remade = meshWith(charts, charts + 20);
  EXPECT_EQ(remade.outcome, Outcome::Complete);
  EXPECT_EQ(remade.mesh, raw.mesh);
}

/// Each edge of the pieces is there once, and either given or there in the other direction, too.
void expectFitTogether(const SplitRegion& split, const FrontInput& input) {
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (const RegionPiece& piece : split.pieces)
    for (const auto& [from, to] : boundaryOf(piece.input).edges)
      edges.emplace_back(piece.vertices[from.value], piece.vertices[to.value]);
  std::sort(edges.begin(), edges.end());
  EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end());
  const MeshBoundary given = boundaryOf(input);
  for (const auto& [from, to] : edges)
    EXPECT_TRUE(given.contains(from, to) ||
                std::binary_search(edges.begin(), edges.end(), std::pair(to, from)));
}

TEST(RegionSplit, LeavesSmallRegionsWhole) {
  const FrontInput input = square(.1);
  const SplitRegion split = splitRegion(input, kPlane, UniformSize(.1));
  ASSERT_EQ(split.pieces.size(), 1u);
  EXPECT_TRUE(split.cutVertices.empty());
  EXPECT_EQ(split.pieces[0].input.vertexCount, input.vertexCount);
}

TEST(RegionSplit, KeepsTheAreaAndSharesCutEdges) {
  for (const FrontInput& input : {square(.02), discWithHole(.01), comb(), manyHoles()}) {
    const SplitRegion split =
        splitRegion(input, kPlane, UniformSize(.02), {areaOf(input) / (.433 * 4e-4) / 7});
    ASSERT_GT(split.pieces.size(), 2u);
    double area = 0;
    for (const RegionPiece& piece : split.pieces) area += areaOf(piece.input);
    EXPECT_NEAR(area, areaOf(input), 1e-9);
    expectFitTogether(split, input);
  }
}

TEST(RegionSplit, TellsWhatEachCutDivides) {
  const FrontInput input = manyHoles();
  const SplitRegion split = splitRegion(input, kPlane, UniformSize(.1), {600});
  ASSERT_GT(split.cuts.size(), 3u);
  EXPECT_EQ(split.cuts[0].depth, 0);
  EXPECT_EQ(split.cuts[0].within.end, split.cutVertices.size());
  EXPECT_EQ(split.cuts[0].pieces.end, split.pieces.size());
  std::size_t vertices = 0;
  for (const RegionCut& cut : split.cuts) {
    vertices += cut.own.end - cut.own.begin;
    // Its vertices are corners of what it divides, and of nothing else.
    for (std::size_t p = 0; p < split.pieces.size(); ++p) {
      const bool isDivided = p >= cut.pieces.begin && p < cut.pieces.end;
      for (const VertexId v : split.pieces[p].vertices) {
        const std::size_t id = v.value - input.vertexCount;  // of the boundary: a large one
        EXPECT_FALSE(id >= cut.own.begin && id < cut.own.end && !isDivided);
        EXPECT_FALSE(id >= cut.within.begin && id < cut.within.end && !isDivided);
      }
    }
  }
  EXPECT_EQ(vertices, split.cutVertices.size());
}

/// A tube around z of circumference 1; u goes once around.
class TubePoints final : public SurfaceEvaluator {
 public:
  SurfacePoint at(double u, double v) const override {
    const double angle = 2 * std::numbers::pi * u, r = 0.5 / std::numbers::pi;
    const Point3 normal{std::cos(angle), std::sin(angle), 0};
    return {r * normal + Point3{0, 0, v}, normal, u, v};
  }
};

/// A tube of height 4: up and down its seam, whose vertices stand at u = 1 and at u = 0.
FrontInput tube(double size) {
  const auto around = static_cast<std::size_t>(1 / size), up = static_cast<std::size_t>(4 / size);
  FrontInput input;
  auto& loop = input.loops.emplace_back();
  const auto add = [&](std::size_t vertex, double u, double v) {
    loop.push_back({VertexId(vertex), TubePoints().at(u, v)});
    loop.back().point.position = TubePoints().at(u == 1 ? 0 : u, v).position;
  };
  const auto top = [&](std::size_t i) { return around + i % around; };
  const auto seam = [&](std::size_t k) { return 2 * around + k - 1; };
  for (std::size_t i = 0; i <= around; ++i) add(i % around, static_cast<double>(i) * size, 0);
  for (std::size_t k = 1; k < up; ++k) add(seam(k), 1, static_cast<double>(k) * size);
  for (std::size_t i = around + 1; i-- > 0;) add(top(i), static_cast<double>(i) * size, 4);
  for (std::size_t k = up; --k > 0;) add(seam(k), 0, static_cast<double>(k) * size);
  input.vertexCount = 2 * around + up - 1;
  return input;
}

TEST(RegionSplit, CutsTubesAcross) {
  const FrontInput input = tube(1. / 32);
  const SplitRegion split = splitRegion(input, TubePoints(), UniformSize(1. / 32), {2500});
  ASSERT_GE(split.pieces.size(), 4u);
  // The first cut, half way up, goes once around: it has about as many edges as the ends.
  const Point3& first = split.cutVertices.front().position;
  EXPECT_NEAR(first.z, 2, 2. / 32);
  EXPECT_GT(distance(split.cutVertices[15].position, first), 0.25);
  expectFitTogether(split, input);
}

TEST(RegionSplit, DrawsReversedRegionsInTheMirror) {
  // Loops clockwise in the parameters: the face is seen from below.
  FrontInput input = square(.02);
  for (auto& loop : input.loops)
    for (BoundaryCorner& c : loop) std::swap(c.point.u, c.point.v);
  class Mirrored final : public SurfaceEvaluator {
   public:
    SurfacePoint at(double u, double v) const override { return {{v, u, 0}, {0, 0, 1}, u, v}; }
  };
  const SplitRegion split = splitRegion(input, Mirrored(), UniformSize(.02), {1000});
  EXPECT_GT(split.pieces.size(), 2u);
  double area = 0;
  for (const RegionPiece& piece : split.pieces) area += areaOf(piece.input);
  EXPECT_NEAR(area, 1, 1e-9);
}

void halveAnEdge(FrontInput& input, std::size_t loop) {
  auto& corners = input.loops[loop];
  const Point3 middle = 0.5 * (corners[0].point.position + corners[1].point.position);
  const SurfacePoint point{middle, {0, 0, 1}, middle.x, middle.y};
  corners.insert(corners.begin() + 1, {VertexId(input.vertexCount++), point});
}

FrontInput withEvenLoops(FrontInput input) {
  for (std::size_t i = 0; i < input.loops.size(); ++i)
    if (input.loops[i].size() % 2 == 1) halveAnEdge(input, i);
  return input;
}

std::size_t oddLoopsOf(const SplitRegion& split) {
  std::size_t odd = 0;
  for (const RegionPiece& piece : split.pieces)
    for (const auto& loop : piece.input.loops) odd += loop.size() % 2;
  return odd;
}

TEST(RegionSplit, KeepsPiecesOfEvenRegionsEven) {
  std::size_t oddBefore = 0;
  for (const FrontInput& given : {square(.02), discWithHole(.01), comb(), manyHoles()}) {
    const FrontInput input = withEvenLoops(given);
    for (const int pieces : {2, 7, 20}) {
      const double elements = areaOf(input) / (.433 * 4e-4) / pieces;
      oddBefore += oddLoopsOf(splitRegion(input, kPlane, UniformSize(.02), {elements}));
      const SplitRegion split = splitRegion(input, kPlane, UniformSize(.02), {elements, true});
      EXPECT_EQ(oddLoopsOf(split), 0u);
      expectFitTogether(split, input);
    }
  }
  EXPECT_GT(oddBefore, 10u);
}

TEST(RegionSplit, KeepsPiecesOfTubesEven) {
  for (const double pieceElements : {300., 1000., 2500.}) {
    const FrontInput input = tube(1. / 32);
    const SplitRegion split =
        splitRegion(input, TubePoints(), UniformSize(1. / 31), {pieceElements, true});
    EXPECT_EQ(oddLoopsOf(split), 0u);
    expectFitTogether(split, input);
  }
}

TEST(RegionSplit, LeavesOneLoopOddWhereTheRegionIsOdd) {
  FrontInput input = square(.02);
  halveAnEdge(input, 0);
  const SplitRegion split = splitRegion(input, kPlane, UniformSize(.02), {500, true});
  EXPECT_GT(split.pieces.size(), 5u);
  EXPECT_EQ(oddLoopsOf(split), 1u);
}

TEST(RegionSplit, ChangesCutsByOneEdgeAtMost) {
  const FrontInput input = square(.0222);
  const SplitRegion split = splitRegion(input, kPlane, UniformSize(.0222), {2000, true});
  for (const RegionCut& cut : split.cuts) {
    const Point3 first = split.cutVertices[cut.own.begin].position;
    const Point3 last = split.cutVertices[cut.own.end - 1].position;
    const auto inner = static_cast<double>(cut.own.end - cut.own.begin);
    EXPECT_NEAR(distance(first, last) / (inner - 1), .0222, .0222 * 1.6 / inner);
  }
}

TEST(RegionSplit, CutsGridsIntoGrids) {
  // Lines halfway between two corners of the boundary.
  const FrontInput input = square(1. / 45);
  const SplitRegion split = splitRegion(input, kPlane, UniformSize(1. / 45), {500, true});
  EXPECT_GT(split.pieces.size(), 5u);
  for (const SurfacePoint& p : split.cutVertices)
    for (const double x : {p.u, p.v}) EXPECT_NEAR(45 * x, std::round(45 * x), 1e-9);
}

TEST(MeshRegion, GivesTheSameMeshForAnyNumberOfThreads) {
  const FrontInput input = manyHoles();
  const RegionMesh one = meshIn(input, .1, 600, 1);
  for (int threads : {2, 3, 7})
    EXPECT_EQ(meshIn(input, .1, 600, threads).result.mesh, one.result.mesh);
}

TEST(MeshRegion, FillsPiecesAsSoundlyAsTheWhole) {
  for (const FrontInput& input : {square(.02), discWithHole(.01), comb(), manyHoles()}) {
    const double size = input.loops.size() == 1 && areaOf(input) < 2 ? .02
                        : input.loops.size() == 2                    ? .01
                                                                     : .1;
    const RegionMesh mesh = meshIn(input, size, areaOf(input) / (.433 * size * size) / 6, 2);
    EXPECT_EQ(mesh.fault, "");
    expectGoodMesh(mesh.result, input, .3);
  }
}

/// Room is made from the pieces so far. The vertices on cuts, which are there before any piece, do
/// not count: they would ask for memory that nothing needs, and that may not be there.
TEST(MeshRegion, MakesRoomForAboutAsManyVerticesAsThereAre) {
  const Mesh mesh = meshIn(square(.004), .004, 300, 2).result.mesh;
  EXPECT_GT(mesh.elements.size(), 100000u);
  EXPECT_LT(static_cast<double>(mesh.vertices.capacity()),
            2 * static_cast<double>(mesh.vertices.size()));
  EXPECT_LT(static_cast<double>(mesh.elements.capacity()),
            2 * static_cast<double>(mesh.elements.size()));
}

TEST(MeshRegion, HidesItsCuts) {
  const FrontInput input = square(.01);
  const double pieceElements = areaOf(input) / (.433 * 1e-4) / 7;
  const SplitRegion split = splitRegion(input, kPlane, UniformSize(.01), {pieceElements});
  const Mesh mesh = meshIn(input, .01, pieceElements, 2).result.mesh;
  double all = 0, atCuts = 0;
  int count = 0;
  for (const Element& element : mesh.elements) {
    const double quality = triangleQuality(mesh, element);
    all += quality;
    if (std::ranges::none_of(element.vertices(), [&](VertexId v) {
          return v.value >= input.vertexCount &&
                 v.value < input.vertexCount + split.cutVertices.size();
        }))
      continue;
    atCuts += quality;
    ++count;
  }
  EXPECT_GT(count, 1000);
  EXPECT_GT(atCuts / count, all / static_cast<double>(mesh.elements.size()) - .005);
}

TEST(MeshRegion, KeepsTheSizesAsLongAsTheCharts) {
  class Maker final : public AF2LocalTransformMaker {
   public:
    explicit Maker(std::weak_ptr<const SizeField> size) : size_(std::move(size)) {}
    std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                          const SurfacePoint& to,
                                                          double unit) const override {
      EXPECT_FALSE(size_.expired());
      return FlatMaker().makeLocalTransform(from, to, unit);
    }

   private:
    std::weak_ptr<const SizeField> size_;
  };
  const auto tools = [] {
    const auto size = std::make_shared<UniformSize>(.05);
    return PieceTools{std::make_unique<Maker>(size), size};
  };
  const FrontInput input = square(.05);
  const RegionMesh mesh =
      meshRegion(AF2Algorithm(triangleSet()), {input, tools, &kPlane, {300}, true, 2}, {});
  EXPECT_EQ(mesh.result.outcome, Outcome::Complete);
}

TEST(MeshRegion, TellsItsProgressAndStopsWhenAsked) {
  const FrontInput input = square(.01);
  std::stop_source source;
  FrontOptions options;
  options.stop = source.get_token();
  std::atomic<std::size_t> calls = 0;
  options.progress = [&](const Progress&) {
    if (++calls == 2) source.request_stop();
  };
  const RegionMesh mesh = meshIn(input, .002, 40000, 2, options);
  EXPECT_EQ(mesh.result.outcome, Outcome::Cancelled);
  EXPECT_GE(calls, 2u);
}

// So that who watches it can tell a long finish from a hang.
TEST(MeshRegion, TellsThatItGoesOnWhileTheMeshIsFinished) {
  const FrontInput input = square(.01);
  const auto callsWith = [&](bool optimize) {
    std::size_t calls = 0;
    FrontOptions options;
    options.progress = [&](const Progress&) { ++calls; };
    const auto tools = [] {
      return PieceTools{std::make_unique<FlatMaker>(), std::make_unique<UniformSize>(.01)};
    };
    meshRegion(AF2Algorithm(triangleSet()), {input, tools, nullptr, {}, optimize}, options);
    return calls;
  };
  EXPECT_GT(callsWith(true), callsWith(false));
}

}  // namespace
}  // namespace af2
