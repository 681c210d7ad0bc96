#include "geometry/occ/edges/cusps.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <gp_Circ.hxx>

#include <cmath>

#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/shapes.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

constexpr double kRadius = 5, kWidth = 3;

/// Between a circle and its tangent, from where they touch.
TopoDS_Face horn() {
  const double height = kRadius - std::sqrt(kRadius * kRadius - kWidth * kWidth);
  const gp_Pnt tip(0, 0, 0), below(kWidth, 0, 0), above(kWidth, height, 0);
  const gp_Circ circle(gp_Ax2({0, kRadius, 0}, gp::DZ()), kRadius);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(tip, below).Edge(),
                               BRepBuilderAPI_MakeEdge(below, above).Edge(),
                               BRepBuilderAPI_MakeEdge(circle, tip, above).Edge());
  return BRepBuilderAPI_MakeFace(wire.Wire());
}

double firstSegment(const ModelMesh& mesh) {
  double least = 1e300;
  for (const EdgeSegment& segment : mesh.segments) {
    const Point3 &from = mesh.vertices[segment.from.value], &to = mesh.vertices[segment.to.value];
    if (std::min(length(from), length(to)) < 1e-9) least = std::min(least, distance(from, to));
  }
  return least;
}

TEST(Cusps, HaveSegmentsSoLongThatNoElementIsUseless) {
  for (const double size : {0.3, 0.1, 0.06}) {
    const ModelMesh result = testing::mesh(horn(), size);
    testing::expectComplete(result);
    EXPECT_GT(testing::leastAngle(result), size > 0.1 ? 1 : 0.6) << size;
    EXPECT_LT(firstSegment(result), 2.1 * size);
  }
}

TEST(Cusps, AreLeftAsTheyAreWhereThatWouldTakeFarLongerSegments) {
  const double size = 0.02;
  const ModelMesh result = testing::mesh(horn(), size);
  testing::expectComplete(result);
  EXPECT_LT(firstSegment(result), 1.2 * size);
}

}  // namespace
}  // namespace af2::geometry
