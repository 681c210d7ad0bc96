#include "geometry/mesh/fans.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/mesh/mesh_check.h"
#include "engine/optimize/optimize.h"
#include "tests/support/meshing.h"

namespace af2::geometry {
namespace {

using namespace af2::testing;

/// A square of side 2 without the tip at the origin. The rim of the fan goes from (0, 2) over
/// (0.9, 0.9) to (2, 0), so that the fan has a reflex corner there.
FaceBoundary squareWithFan() {
  FaceBoundary boundary;
  addLoop(boundary.input, {{2, 0}, {2, 2}, {0, 2}, {0.9, 0.9}});
  boundary.points = {0, 1, 2};  // (0.9, 0.9) lies inside
  FaceBoundary::Fan& fan = boundary.fans.emplace_back();
  fan.tip = 3;
  fan.place = boundary.input.loops[0][0].point;
  fan.place.position = {0, 0, 0};
  fan.rim = {VertexId(2), VertexId(3), VertexId(0)};
  return boundary;
}

Mesh meshOf(const FaceBoundary& boundary) {
  Mesh mesh;
  for (const BoundaryCorner& c : boundary.input.loops[0]) mesh.vertices.push_back(c.point);
  Element element;
  element.corners = {VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  mesh.elements.push_back(element);
  mesh.origins.emplace_back();
  return mesh;
}

TEST(Fans, HaveABoundaryAroundTheirTips) {
  FaceBoundary boundary = squareWithFan();
  Mesh mesh = meshOf(boundary);
  addFans(boundary, FanElements::Quads, {}, mesh);
  ASSERT_EQ(mesh.elements.size(), 3u) << "no quadrilateral fits";
  EXPECT_EQ(faultOf(mesh, boundaryWithFans(boundary)), "");
  EXPECT_EQ(boundaryWithFans(boundary).fixedCount, 4u);
}

TEST(Fans, BecomeQuadrilateralsWhenTheirRimsMayMove) {
  FaceBoundary boundary = squareWithFan();
  Mesh mesh = meshOf(boundary);
  addFans(boundary, FanElements::Quads, {}, mesh);
  EXPECT_EQ(joinTriangles(mesh, boundaryWithFans(boundary), FlatMaker()), 1u);
  EXPECT_TRUE(std::ranges::all_of(mesh.elements, &Element::isQuad));
  EXPECT_NEAR(areaOf(mesh), 4, 1e-9);
}

TEST(Fans, BecomeQuadrilateralsWhenTheirRimsLeaveTheTip) {
  FaceBoundary boundary;
  addLoop(boundary.input, {{2, 0}, {2.2, 1}, {2, 2}, {1, 2.2}, {0, 2}, {0.9, 0.9}});
  boundary.points = {0, 1, 2, 3, 4};  // (0.9, 0.9) lies inside
  FaceBoundary::Fan& fan = boundary.fans.emplace_back();
  fan.tip = 5;
  fan.place = flatCorner(0, {0, 0}).point;
  fan.rim = {VertexId(4), VertexId(5), VertexId(0)};
  Mesh mesh;
  for (const BoundaryCorner& c : boundary.input.loops[0]) mesh.vertices.push_back(c.point);
  mesh.elements = {{{VertexId(0), VertexId(1), VertexId(2), VertexId(5)}},
                   {{VertexId(5), VertexId(2), VertexId(3), VertexId(4)}}};
  mesh.origins.resize(2);
  addFans(boundary, FanElements::Quads, {}, mesh);
  ASSERT_EQ(mesh.elements.size(), 4u) << "no quadrilateral fits";
  EXPECT_EQ(joinAtTips(boundary, FlatMaker(), mesh), 1u);
  EXPECT_TRUE(std::ranges::all_of(mesh.elements, &Element::isQuad));
  EXPECT_EQ(mesh.origins.size(), mesh.elements.size());
  EXPECT_EQ(faultOf(mesh, boundaryWithFans(boundary)), "");
  EXPECT_NEAR(areaOf(mesh), 4.4, 1e-9);
}

}  // namespace
}  // namespace af2::geometry
