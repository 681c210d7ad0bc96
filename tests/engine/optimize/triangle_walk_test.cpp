// Joining triangles where charts show a few elements only.
#include "engine/optimize/triangle_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "engine/mesh/mesh_check.h"
#include "engine/optimize/optimize.h"
#include "tests/support/quad_grid.h"

namespace af2 {
namespace {

using namespace af2::testing;

/// As on a surface that bends sharply.
class ShortSightedChart final : public AF2LocalTransform {
 public:
  ShortSightedChart(const SurfacePoint& from, const SurfacePoint& to, double unit)
      : chart_(flatChart(from.position, to.position, unit)) {}
  ChartPoint transformFromSurface(const SurfacePoint& p) const override {
    constexpr double kSight = 2.5;
    ChartPoint point = chart_.transformFromSurface(p);
    if (length(point.position) > kSight) point.view = ChartView::Hidden;
    return point;
  }
  std::optional<SurfacePoint> transformToSurface(Point2 p) const override {
    return chart_.transformToSurface(p);
  }

 private:
  PlaneChart chart_;
};

class ShortSightedMaker final : public AF2LocalTransformMaker {
 public:
  std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double unit) const override {
    return std::make_unique<ShortSightedChart>(from, to, unit);
  }
};

TEST(TriangleWalk, TakesFewerElementsWhereChartsHideSome) {
  QuadGrid grid(8);
  grid.split(4, 4);
  EXPECT_EQ(joinTriangles(grid.mesh, boundaryOf(grid.input), ShortSightedMaker()), 1u);
  EXPECT_TRUE(std::ranges::all_of(grid.mesh.elements, &Element::isQuad));
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
}

}  // namespace
}  // namespace af2
