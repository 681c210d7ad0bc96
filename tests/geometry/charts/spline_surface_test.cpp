#include "geometry/charts/spline_surface.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

constexpr SplineSurface::Box kWhole{0, 2, 0, 1};

/// Degrees 2 and 1 with a knot of u at 1: (u, v, u^2), exactly.
SplineDefinition parabola() {
  SplineDefinition definition;
  definition.u = {2, {0, 0, 0, 1, 2, 2, 2}};
  definition.v = {1, {0, 0, 1, 1}};
  for (const Point2 p : {Point2{0, 0}, Point2{0.5, 0}, Point2{1.5, 2}, Point2{2, 4}})
    for (const double v : {0.0, 1.0}) definition.poles.push_back({p.x, v, p.y});
  return definition;
}

TEST(SplineSurface, GivesValuesAndDerivatives) {
  const auto surface = SplineSurface::make(parabola(), kWhole);
  ASSERT_TRUE(surface);
  for (const double u : {0.0, 0.3, 1.0, 1.7, 2.0}) {
    const auto jet = surface->jetAt(u, 0.25);
    ASSERT_TRUE(jet);
    EXPECT_LT(distance(jet->position, {u, 0.25, u * u}), 1e-15);
    EXPECT_LT(distance(jet->du, {1, 0, 2 * u}), 1e-14);
    EXPECT_LT(distance(jet->dv, {0, 1, 0}), 1e-15);
    EXPECT_LT(distance(jet->duu, {0, 0, 2}), 1e-14);
    EXPECT_LT(length(jet->duv) + length(jet->dvv), 1e-14);
  }
}

TEST(SplineSurface, GoesOnBeyondItsEnds) {
  const auto surface = SplineSurface::make(parabola(), kWhole);
  EXPECT_LT(distance(surface->frameAt(-1, 2)->position, {-1, 2, 1}), 1e-14);
  EXPECT_LT(distance(surface->frameAt(3, -1)->position, {3, -1, 9}), 1e-14);
}

/// Derivatives far from the origin must not suffer from the size of the coordinates.
TEST(SplineSurface, KeepsItsDerivativesFarFromTheOrigin) {
  SplineDefinition far = parabola();
  for (Point3& pole : far.poles) pole = pole + Point3{1 << 30, 1 << 29, -(1 << 30)};
  const auto near = SplineSurface::make(parabola(), kWhole),
             there = SplineSurface::make(far, kWhole);
  for (const double u : {0.3, 1.7}) {
    EXPECT_LT(distance(near->jetAt(u, 0.5)->du, there->jetAt(u, 0.5)->du), 1e-14);
    EXPECT_LT(distance(near->jetAt(u, 0.5)->duu, there->jetAt(u, 0.5)->duu), 1e-14);
  }
}

TEST(SplineSurface, HoldsACircleByItsWeights) {
  SplineDefinition quarter;
  quarter.u = {2, {0, 0, 0, 1, 1, 1}};
  quarter.v = {1, {0, 0, 1, 1}};
  quarter.poles = {{1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}, {0, 1, 0}, {0, 1, 1}};
  const double w = std::sqrt(0.5);
  quarter.weights = {1, 1, w, w, 1, 1};
  const auto surface = SplineSurface::make(quarter, {0, 1, 0, 1});
  for (const double u : {0.0, 0.2, 0.5, 0.9}) {
    const auto jet = surface->jetAt(u, 0.3);
    const Point3 radius{jet->position.x, jet->position.y, 0};
    EXPECT_NEAR(length(radius), 1, 1e-15);
    EXPECT_NEAR(dot(radius, jet->du), 0, 1e-15);
    EXPECT_NEAR(dot(radius, jet->duu) + dot(jet->du, jet->du), 0, 1e-14);
  }
}

TEST(SplineSurface, RefusesWhatIsNoSurfaceOrTooLarge) {
  SplineDefinition fewPoles = parabola(), falling = parabola(), narrow = parabola();
  fewPoles.poles.pop_back();
  falling.u.knots = {0, 0, 0, 3, 2, 2, 2};
  narrow.v.knots = {1, 1, 1, 1};
  EXPECT_FALSE(SplineSurface::make(fewPoles, kWhole));
  EXPECT_FALSE(SplineSurface::make(falling, kWhole));
  EXPECT_FALSE(SplineSurface::make(narrow, kWhole));
  SplineDefinition steep = parabola();
  steep.u.degree = SplineSurface::kMaxDegree + 1;
  EXPECT_FALSE(SplineSurface::make(steep, kWhole));
  EXPECT_FALSE(SplineSurface::make(parabola(), kWhole, 20));
  EXPECT_TRUE(SplineSurface::make(parabola(), kWhole, 60));
}

}  // namespace
}  // namespace af2::geometry
