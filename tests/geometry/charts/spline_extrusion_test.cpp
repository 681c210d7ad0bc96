#include "geometry/charts/spline_extrusion.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

/// A bent curve of three poles and weights, along a line of three poles that are not spread evenly.
SplineDefinition extruded() {
  SplineDefinition definition;
  definition.u = {2, {0, 0, 0, 1, 1, 1}};
  definition.v = {2, {0, 0, 0, 1, 1, 1}};
  const Point3 direction = unit({0, 1, 2});
  const double weights[] = {1, 0.7, 1.2};
  for (int i = 0; i < 3; ++i)
    for (const double along : {0.0, 1.0, 5.0}) {
      definition.poles.push_back(Point3{1.0 * i, 0, i == 1 ? 2.0 : 0.0} + along * direction);
      definition.weights.push_back(weights[i] * (along == 1 ? 0.5 : 1));
    }
  return definition;
}

/// u and v in each other's place.
SplineDefinition exchanged(const SplineDefinition& definition) {
  SplineDefinition other{definition.v, definition.u, {}, {}};
  for (std::size_t j = 0; j < definition.v.poleCount(); ++j)
    for (std::size_t i = 0; i < definition.u.poleCount(); ++i) {
      other.poles.push_back(definition.poles[i * definition.v.poleCount() + j]);
      other.weights.push_back(definition.weights[i * definition.v.poleCount() + j]);
    }
  return other;
}

TEST(SplineExtrusion, IsFoundAlongEitherParameter) {
  for (const bool alongU : {false, true}) {
    const auto extrusion = extrusionOf(alongU ? exchanged(extruded()) : extruded());
    ASSERT_TRUE(extrusion);
    EXPECT_EQ(extrusion->isAlongU, alongU);
    EXPECT_LT(distance(extrusion->direction, unit({0, 1, 2})), 1e-15);
  }
}

TEST(SplineExtrusion, IsNoSurfaceThatIsNearlyOne) {
  ASSERT_EQ(extruded().poles.size(), 9u);
  for (std::size_t i = 1; i < 9; ++i) {
    SplineDefinition moved = extruded();
    moved.poles[i] = moved.poles[i] + Point3{0, 0.001, 0};
    EXPECT_FALSE(extrusionOf(moved)) << i;
    SplineDefinition weighed = extruded();
    weighed.weights[i] *= 1.001;
    EXPECT_FALSE(extrusionOf(weighed)) << i;
  }
}

/// The rows come back to where they started.
TEST(SplineExtrusion, IsNoTube) {
  SplineDefinition tube;
  tube.u = tube.v = {1, {0, 0, 1, 2, 2}};
  for (const double height : {0.0, 1.0, 3.0})
    for (const double x : {0.0, 1.0, 0.0}) tube.poles.push_back({x, x * height, height});
  EXPECT_FALSE(extrusionOf(tube));
}

}  // namespace
}  // namespace af2::geometry
