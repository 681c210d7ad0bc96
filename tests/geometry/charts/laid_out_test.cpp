#include "geometry/charts/laid_out.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/mesh/mesh_check.h"
#include "engine/surface/plane_chart.h"
#include "geometry/charts/unrolled_surfaces.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

const AxisFrame kUpright{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// A whole tube of radius 1: `around` segments around, `along` along the seam, which is there in
/// both directions.
FrontInput tube(const UnrolledCylinder& surface, int around, int along, double height) {
  FrontInput input;
  auto& loop = input.loops.emplace_back();
  const auto add = [&](int i, int j) {
    const int vertex = j * around + i % around;
    loop.push_back({VertexId(static_cast<std::size_t>(vertex)),
                    surface.pointAt(2 * kPi * i / around, height * j / along)});
  };
  for (int i = 0; i < around; ++i) add(i, 0);
  for (int j = 0; j < along; ++j) add(around, j);
  for (int i = around; i > 0; --i) add(i, along);
  for (int j = along; j > 0; --j) add(0, j);
  // Vertices are those of the rims and of the seam only.
  std::vector<std::size_t> ids;
  for (BoundaryCorner& corner : loop) {
    const auto found = std::find(ids.begin(), ids.end(), corner.vertex.value);
    const auto id = static_cast<std::size_t>(found - ids.begin());
    if (found == ids.end()) ids.push_back(corner.vertex.value);
    corner.vertex = VertexId(id);
  }
  // One position for each vertex, whatever rounding makes of a whole turn.
  std::vector<Point3> positions(ids.size());
  std::vector<bool> isKnown(ids.size(), false);
  for (BoundaryCorner& corner : loop) {
    if (!isKnown[corner.vertex.value]) positions[corner.vertex.value] = corner.point.position;
    isKnown[corner.vertex.value] = true;
    corner.point.position = positions[corner.vertex.value];
  }
  input.vertexCount = ids.size();
  return input;
}

class LaidOut : public ::testing::Test {
 protected:
  LaidOut() : surface(kUpright, CylinderSurface({}, {0, 0, 1}, 1, Side::Outer)), map(surface) {}
  UnrolledCylinder surface;
  UnrolledMap map;
};

TEST_F(LaidOut, AVertexOfASeamHasAPlaceOnEachSide) {
  const FrontInput input = tube(surface, 20, 5, 1.5);
  const LaidOutFront front = layOut(input, map);
  EXPECT_TRUE(front.hasTwins);
  EXPECT_EQ(front.input.vertexCount, input.vertexCount + 6);  // those of the seam
  for (std::size_t i = 0; i < input.loops[0].size(); ++i)
    EXPECT_EQ(front.original[front.input.loops[0][i].vertex.value], input.loops[0][i].vertex);
}

TEST_F(LaidOut, ATubeIsMeshedInThePlaneAndLiftedBack) {
  const FrontInput input = tube(surface, 20, 5, 1.5);
  const LaidOutFront front = layOut(input, map);
  const AF2Algorithm algorithm(testing::triangleSet());
  MeshingResult result = algorithm.execute(PlaneChartMaker(), front.input, UniformSize(0.3));
  ASSERT_EQ(result.outcome, Outcome::Complete);
  lift(result, front, input, map);
  EXPECT_EQ(faultOf(result.mesh, boundaryOf(input)), "");
  EXPECT_EQ(faultOfLifted(result.mesh, front, input), "");
  for (const SurfacePoint& p : result.mesh.vertices)
    EXPECT_NEAR(length(Point2{p.position.x, p.position.y}), 1, 1e-14);
}

/// Three segments around: what lies flat in the plane folds over in space.
TEST_F(LaidOut, FoldsAreSeen) {
  FrontInput input;
  auto& loop = input.loops.emplace_back();
  const Point2 places[] = {{0, 0}, {2.9, 0}, {2.9, 0.1}, {0, 0.1}};
  for (std::size_t i = 0; i < 4; ++i)
    loop.push_back({VertexId(i), surface.pointAt(places[i].x, places[i].y)});
  input.vertexCount = 4;
  const LaidOutFront front = layOut(input, map);
  Mesh mesh;
  for (const BoundaryCorner& corner : loop) mesh.vertices.push_back(corner.point);
  mesh.elements = {Element{{VertexId(0), VertexId(1), VertexId(2), VertexId()}},
                   Element{{VertexId(0), VertexId(2), VertexId(3), VertexId()}}};
  mesh.origins.resize(2);
  EXPECT_NE(faultOfLifted(mesh, front, input), "");
  EXPECT_EQ(faultOfLifted(mesh, front, input, true), "");
}

TEST_F(LaidOut, SizesAreThoseOfTheSurface) {
  const UniformSize size(0.25);
  EXPECT_EQ(LaidOutSize(size, map).sizeAt(pointInPlane({1, 2})), 0.25);
}

}  // namespace
}  // namespace af2::geometry
