// That an observer hears of every change that is kept, and changes nothing.
#include "engine/optimize/finish_observer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "engine/optimize/optimize.h"
#include "tests/support/meshing.h"
#include "tests/support/quad_grid.h"

namespace af2 {
namespace {

using namespace af2::testing;

/// Repeats the changes on a copy of the mesh.
class Repeater final : public FinishObserver {
 public:
  void finishBegun(const Mesh& mesh) override {
    vertices = mesh.vertices;
    for (const Element& element : mesh.elements) ++elements[element.corners];
  }
  void actKept(const FinishAct& act) override {
    ++counts[act.kind];
    if (act.kind == FinishAct::Kind::Move) {
      EXPECT_EQ(vertices[act.vertex.value].position, act.from);
      vertices[act.vertex.value].position = act.to;
    }
    for (const Element& element : act.before) --elements[element.corners];
    for (const Element& element : act.after) ++elements[element.corners];
    if (act.kind == FinishAct::Kind::SwapForQuality) {
      EXPECT_LT(act.worstAfter, act.worstBefore);
    }
  }
  void finishEnded(const Mesh& mesh, bool isSound) override {
    EXPECT_TRUE(isSound);
    EXPECT_EQ(cornersOf(mesh), repeated());
    ++ended;
  }

  std::map<FinishAct::Kind, std::size_t> counts;
  int ended = 0;

 private:
  using Corners = std::vector<std::tuple<double, double, double>>;

  static void add(const std::vector<SurfacePoint>& at, const Element& element,
                  std::vector<Corners>& all) {
    Corners corners;
    for (const VertexId v : element.vertices()) {
      const Point3& p = at[v.value].position;
      corners.emplace_back(p.x, p.y, p.z);
    }
    all.push_back(std::move(corners));
  }
  static std::vector<Corners> cornersOf(const Mesh& mesh) {
    std::vector<Corners> all;
    for (const Element& element : mesh.elements) add(mesh.vertices, element, all);
    std::ranges::sort(all);
    return all;
  }
  std::vector<Corners> repeated() const {
    std::vector<Corners> all;
    for (const auto& [corners, count] : elements)
      for (int i = 0; i < count; ++i) add(vertices, {corners}, all);
    std::ranges::sort(all);
    return all;
  }

  std::vector<SurfacePoint> vertices;
  std::map<std::array<VertexId, 4>, int> elements;
};

TEST(FinishObserver, HearsOfEveryChangeOfTrianglesInOrder) {
  const FrontInput input = discWithHole(.02);
  const Mesh front = AF2Algorithm(triangleSet()).execute(FlatMaker(), input, UniformSize(.02)).mesh;
  Mesh observed = front, alone = front;
  Repeater repeater;
  OptimizeOptions options;
  options.observer = &repeater;
  const OptimizeReport report = optimizeMesh(observed, boundaryOf(input), FlatMaker(), options);
  optimizeMesh(alone, boundaryOf(input), FlatMaker());
  EXPECT_EQ(observed, alone);
  EXPECT_EQ(repeater.ended, 1);
  EXPECT_GT(report.swaps, 0u);
  EXPECT_EQ(repeater.counts[FinishAct::Kind::SwapForValence] +
                repeater.counts[FinishAct::Kind::SwapForQuality],
            report.swaps);
  EXPECT_EQ(repeater.counts[FinishAct::Kind::Move], report.moves);
  EXPECT_EQ(repeater.counts[FinishAct::Kind::Collapse], report.collapses);
}

TEST(FinishObserver, HearsOfReplacementsOfQuadrilaterals) {
  QuadGrid grid(6);
  grid.split(1, 1);
  grid.split(4, 1);
  Repeater repeater;
  OptimizeOptions options;
  options.observer = &repeater;
  const OptimizeReport report =
      optimizeMesh(grid.mesh, boundaryOf(grid.input), FlatMaker(), options);
  EXPECT_GT(report.replacements, 0u);
  EXPECT_EQ(
      repeater.counts[FinishAct::Kind::Replacement] + repeater.counts[FinishAct::Kind::Pairing],
      report.replacements);
}

}  // namespace
}  // namespace af2
