#include "geometry/domain/points_in_domain.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "geometry/planar/mesh_planar.h"

namespace af2::geometry {
namespace {

/// A square of side 4 with a square hole of side 1 in its middle.
DomainModel squareWithHole() {
  PlanarDomain domain;
  domain.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1.5, 1.5}, {2.5, 1.5}, {2.5, 2.5}, {1.5, 2.5}};
  for (int i = 0; i < 8; ++i) {
    PlanarDomain::Segment& segment = domain.segments.emplace_back();
    segment.from = i;
    segment.to = i < 4 ? (i + 1) % 4 : 4 + (i - 3) % 4;
    segment.edge = i + 1;
  }
  domain.holes = {{2, 2}};
  MeshingOptions options;
  options.sizes.size = 1;
  return planarModel(domain, options);
}

TEST(PointsInDomain, StayInsideTheFace) {
  const DomainModel model = squareWithHole();
  const PointsInDomain points(model);
  const PointInDomain inside = points.nearest({1, 1, 0});
  EXPECT_EQ(inside.point.position, (Point3{1, 1, 0}));
  EXPECT_EQ(inside.distance, 0);
  EXPECT_EQ(inside.face, 1);
  EXPECT_EQ(points.nearest({5, 1, 0}).point.position, (Point3{4, 1, 0}));
  EXPECT_EQ(points.nearest({-1, -1, 0}).point.position, (Point3{0, 0, 0}));
}

TEST(PointsInDomain, AreNotInHoles) {
  const DomainModel model = squareWithHole();
  const PointInDomain found = PointsInDomain(model).nearest({1.8, 2, 0}, 1);
  EXPECT_EQ(found.point.position, (Point3{1.5, 2, 0}));
  EXPECT_NEAR(found.distance, 0.3, 1e-15);
}

TEST(PointsInDomain, HaveTheParametersOfTheirSurface) {
  const DomainModel model = squareWithHole();
  const PointsInDomain points(model);
  const SurfacePoint foot = points.nearest({1, 3, 0}).point;
  EXPECT_EQ(points.at(1, foot.u, foot.v).position, (Point3{1, 3, 0}));
  EXPECT_THROW(points.at(2, 0, 0), InputError);
  EXPECT_THROW(points.nearest({0, 0, 0}, 2), InputError);
}

}  // namespace
}  // namespace af2::geometry
