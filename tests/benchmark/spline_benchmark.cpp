// The evaluation of splines: once for each new vertex and each step of Newton's method.
#include <benchmark/benchmark.h>

#include <cmath>

#include "geometry/charts/spline_surface.h"

namespace af2::benchmark {
namespace {

using geometry::SplineBasis;
using geometry::SplineDefinition;
using geometry::SplineSurface;

constexpr int kSpans = 20;

SplineBasis evenBasis(int degree) {
  SplineBasis basis{degree, {}};
  for (int k = -degree; k <= kSpans + degree; ++k)
    basis.knots.push_back(std::min(std::max(k, 0), kSpans));
  return basis;
}

SplineSurface waves(int degree, bool isRational) {
  SplineDefinition definition;
  definition.u = definition.v = evenBasis(degree);
  for (std::size_t i = 0; i < definition.u.poleCount(); ++i)
    for (std::size_t j = 0; j < definition.v.poleCount(); ++j) {
      const auto x = static_cast<double>(i), y = static_cast<double>(j);
      definition.poles.push_back({x, y, std::sin(0.7 * x) * std::cos(0.4 * y)});
      if (isRational) definition.weights.push_back(1 + 0.1 * std::sin(x + y));
    }
  return *SplineSurface::make(definition, {0, kSpans, 0, kSpans});
}

/// A walk across the surface in steps that are small against a span, as a front makes them.
template <class Evaluate>
void walk(::benchmark::State& state, const Evaluate& evaluate) {
  const SplineSurface surface = waves(static_cast<int>(state.range(0)), state.range(1) != 0);
  double u = 0, v = 0;
  for (auto _ : state) {
    ::benchmark::DoNotOptimize(evaluate(surface, u, v));
    if ((u += 0.037) > kSpans) u -= kSpans;
    if ((v += 0.0013) > kSpans) v -= kSpans;
  }
}

void splineFrame(::benchmark::State& state) {
  walk(state, [](const SplineSurface& s, double u, double v) { return s.frameAt(u, v); });
}
BENCHMARK(splineFrame)->ArgNames({"degree", "rational"})->ArgsProduct({{1, 2, 3, 5, 8}, {0, 1}});

void splineJet(::benchmark::State& state) {
  walk(state, [](const SplineSurface& s, double u, double v) { return s.jetAt(u, v); });
}
BENCHMARK(splineJet)->ArgNames({"degree", "rational"})->ArgsProduct({{1, 2, 3, 5, 8}, {0, 1}});

}  // namespace
}  // namespace af2::benchmark
