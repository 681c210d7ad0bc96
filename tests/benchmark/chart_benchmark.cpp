// The charts: made once for each step, then asked for one new vertex every second step.
#include <benchmark/benchmark.h>

#include <cmath>

#include "engine/surface/plane_chart.h"
#include "geometry/charts/mean_normal_chart.h"
#include "geometry/charts/quadric_surfaces.h"

namespace af2::benchmark {
namespace {

constexpr double kSize = 0.05;

SurfacePoint onUnitSphere(double longitude, double latitude) {
  const Point3 p{std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                 std::sin(latitude)};
  return {p, p, longitude, latitude};
}

SurfacePoint onUnitCylinder(double angle, double height) {
  const Point3 normal{std::cos(angle), std::sin(angle), 0};
  return {{normal.x, normal.y, height}, normal, angle, height};
}

void makeAndLift(::benchmark::State& state, const AF2LocalTransformMaker& maker,
                 const SurfacePoint& from, const SurfacePoint& to) {
  ChartSlot slot;
  for (auto _ : state) {
    const AF2LocalTransform& chart = maker.makeLocalTransformIn(slot, from, to, kSize);
    ::benchmark::DoNotOptimize(chart.transformToSurface({0.5, 0.866}));
  }
}

void planeChart(::benchmark::State& state) {
  const SurfacePoint from{{0, 0, 0}, {0, 0, 1}}, to{{kSize, 0, 0}, {0, 0, 1}};
  makeAndLift(state, PlaneChartMaker(), from, to);
}
BENCHMARK(planeChart);

void cylinderChart(::benchmark::State& state) {
  const geometry::CylinderSurface cylinder({0, 0, 0}, {0, 0, 1}, 1, geometry::Side::Outer);
  makeAndLift(state, geometry::MeanNormalChartMaker(cylinder), onUnitCylinder(0.3, 0),
              onUnitCylinder(0.3 + kSize, 0));
}
BENCHMARK(cylinderChart);

void sphereChart(::benchmark::State& state) {
  const geometry::SphereSurface sphere({0, 0, 0}, 1, geometry::Side::Outer);
  makeAndLift(state, geometry::MeanNormalChartMaker(sphere), onUnitSphere(0.3, 0.4),
              onUnitSphere(0.3 + kSize, 0.4));
}
BENCHMARK(sphereChart);

}  // namespace
}  // namespace af2::benchmark
