// Orientation and crossing: points in general position, where the filter answers, and points on
// one line, where exact arithmetic must.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>

#include "engine/base/predicates.h"
#include "random_points.h"

namespace af2::benchmark {
namespace {

void orientationOfScatteredPoints(::benchmark::State& state) {
  const auto points = scatteredPoints();
  std::size_t i = 0;
  for (auto _ : state) {
    ::benchmark::DoNotOptimize(orientation(points[i], points[i + 1], points[i + 2]));
    i = (i + 1) % (kPoints - 2);
  }
}
BENCHMARK(orientationOfScatteredPoints);

void orientationOfNearlyCollinearPoints(::benchmark::State& state) {
  const auto points = nearlyCollinearPoints();
  std::size_t i = 0;
  for (auto _ : state) {
    ::benchmark::DoNotOptimize(orientation(points[i], points[i + 1], points[i + 2]));
    i = (i + 1) % (kPoints - 2);
  }
}
BENCHMARK(orientationOfNearlyCollinearPoints);

void crossingOfScatteredSegments(::benchmark::State& state) {
  const auto points = scatteredPoints();
  std::size_t i = 0;
  for (auto _ : state) {
    ::benchmark::DoNotOptimize(
        segmentsMeet(points[i], points[i + 1], points[i + 2], points[i + 3]));
    i = (i + 1) % (kPoints - 3);
  }
}
BENCHMARK(crossingOfScatteredSegments);

}  // namespace
}  // namespace af2::benchmark
