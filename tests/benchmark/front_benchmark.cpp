// The index of the front, the choice of a rule at one edge, and the whole front in the plane.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/front/front.h"
#include "engine/front/front_index.h"
#include "engine/run/algorithm.h"
#include "engine/step/candidate_choice.h"
#include "tests/support/flat_surface.h"
#include "tests/support/triangle_rules.h"

namespace af2::benchmark {
namespace {

/// The boundary of the unit square, divided, as a front with its index.
struct SquareFront {
  explicit SquareFront(double size) : index({{0, 0, 0}, {1, 1, 0}}, size) {
    const FrontInput input = testing::square(size);
    const auto& loop = input.loops.front();
    const std::vector<double> sizes(loop.size(), size);
    front.addLoop(loop, sizes);
    for (std::size_t i = 0; i < loop.size(); ++i) index.insert(front, PlaceId(i));
  }
  Front front;
  FrontIndex index;
};

void indexEraseAndInsert(::benchmark::State& state) {
  SquareFront square(1e-3);
  const std::size_t count = square.front.edgeCount();
  std::size_t i = 0;
  for (auto _ : state) {
    square.index.erase(PlaceId(i));
    square.index.insert(square.front, PlaceId(i));
    i = (i + 997) % count;
  }
}
BENCHMARK(indexEraseAndInsert);

void indexSearch(::benchmark::State& state) {
  const double size = 1e-3;
  const SquareFront square(size);
  const std::size_t count = square.front.edgeCount();
  std::vector<PlaceId> room;
  std::size_t i = 0, found = 0;
  for (auto _ : state) {
    const Point3 at = square.front[PlaceId(i)].point.position;
    const Point3 reach{3 * size, 3 * size, 3 * size};
    found += square.index.collectNear({at - reach, at + reach}, room).count;
    i = (i + 997) % count;
  }
  state.counters["edges"] =
      ::benchmark::Counter(static_cast<double>(found), ::benchmark::Counter::kAvgIterations);
}
BENCHMARK(indexSearch);

/// Everything that one step decides: gather, match, score, test zones.
void chooseRule(::benchmark::State& state) {
  const double size = 1e-3;
  const SquareFront square(size);
  const auto set = testing::triangleSet();
  const CompiledRules rules(*set);
  const UniformSize sizes(size);
  const std::vector<std::uint8_t> valence(square.front.capacity(), 0);
  CandidateChoice choice(rules, square.front, square.index, sizes, valence);
  const std::size_t count = square.front.edgeCount();
  std::size_t i = 0;
  for (auto _ : state) {
    const PlaceId base(i);
    const PlaneChart plane =
        testing::flatChart(square.front[base].point.position,
                           square.front[square.front.next(base)].point.position, size);
    const StepChart chart(plane, size);
    ::benchmark::DoNotOptimize(choice.choose(chart, base));
    i = (i + 997) % count;
  }
}
BENCHMARK(chooseRule);

using Region = FrontInput (*)(double);

void meshPlane(::benchmark::State& state, Region region) {
  const AF2Algorithm algorithm(testing::triangleSet());
  const double size = 1.0 / static_cast<double>(state.range(0));
  const FrontInput input = region(size);
  const UniformSize sizes(size);
  std::size_t triangles = 0;
  for (auto _ : state) {
    const MeshingResult result = algorithm.execute(testing::FlatMaker(), input, sizes);
    if (result.outcome != Outcome::Complete) state.SkipWithError("the front got stuck");
    triangles += result.mesh.elements.size();
  }
  state.counters["triangles"] =
      ::benchmark::Counter(static_cast<double>(triangles), ::benchmark::Counter::kAvgIterations);
  state.counters["triangles/s"] =
      ::benchmark::Counter(static_cast<double>(triangles), ::benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(meshPlane, square, testing::square)
    ->Arg(60)
    ->Arg(200)
    ->Arg(650)
    ->Unit(::benchmark::kMillisecond);
BENCHMARK_CAPTURE(meshPlane, discWithHole, testing::discWithHole)
    ->Arg(75)
    ->Arg(250)
    ->Arg(800)
    ->Unit(::benchmark::kMillisecond);

}  // namespace
}  // namespace af2::benchmark
