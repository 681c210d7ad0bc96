// The free zone of the first triangle rule: made from a match, then asked about points and edges,
// in the open form that a user's own class has and in the fast form that the engine prefers.
#include "engine/rule/free_zone.h"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <span>
#include <vector>

#include "engine/step/compiled_rules.h"
#include "random_points.h"
#include "tests/support/triangle_rules.h"

namespace af2::benchmark {
namespace {

const std::vector<Point2> kBase = {{0, 0}, {1, 0}};

/// Outlives the benchmark: a zone of a compiled rule refers to its rule set.
const CompiledRules& rules() {
  static const auto set = testing::triangleSet();
  static const CompiledRules compiled(*set);
  return compiled;
}

std::unique_ptr<const AF2FreeZone> openZone() {
  const AF2Surroundings surroundings;
  return rules()
      .rules()
      .front()
      .rule->definition()
      .zone->makeFreeZone({kBase, 1, &surroundings})
      .zone;
}

void makeOpenForm(::benchmark::State& state) {
  for (auto _ : state) ::benchmark::DoNotOptimize(openZone());
}
BENCHMARK(makeOpenForm);

void makeFastForm(::benchmark::State& state) {
  const AffineBatch& batch = rules().rules().front().zone->at(1);
  for (auto _ : state) {
    double x[AffineBatch::kCapacity], y[AffineBatch::kCapacity];
    batch.evaluate(kBase.data(), x, y);
    Point2 corners[AffineBatch::kCapacity];
    for (int i = 0; i < batch.count; ++i) corners[i] = {x[i], y[i]};
    ::benchmark::DoNotOptimize(convex_polygon::normalize(corners, batch.count));
  }
}
BENCHMARK(makeFastForm);

void zoneContainsPoint(::benchmark::State& state) {
  const auto zone = openZone();
  const Points points = scatteredPoints();
  std::size_t i = 0;
  for (auto _ : state) {
    ::benchmark::DoNotOptimize(zone->contains(points[i], ZoneBoundary::Counts));
    i = (i + 1) % kPoints;
  }
}
BENCHMARK(zoneContainsPoint);

void zoneMeetsSegment(::benchmark::State& state) {
  const auto zone = openZone();
  const Points points = scatteredPoints();
  std::size_t i = 0;
  for (auto _ : state) {
    ::benchmark::DoNotOptimize(zone->meets(points[i], points[i + 1], ZoneBoundary::Ignored));
    i = (i + 1) % (kPoints - 1);
  }
}
BENCHMARK(zoneMeetsSegment);

}  // namespace
}  // namespace af2::benchmark
