// Random regions: every one must be meshed completely and soundly.
#include <gtest/gtest.h>

#include <random>

#include "tests/support/meshing.h"

namespace af2 {
namespace {

using namespace af2::testing;
using Points = std::vector<Point2>;

/// A star-shaped polygon around a centre, its corners at random distances.
Points starShaped(std::mt19937& random, Point2 center, double radius, double roughness) {
  std::uniform_real_distribution<double> unit(0, 1);
  const int n = 5 + static_cast<int>(unit(random) * 12);
  Points corners;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * M_PI * (i + .8 * unit(random)) / n;
    const double r = radius * (1 - roughness * unit(random));
    corners.push_back(center + r * Point2{std::cos(t), std::sin(t)});
  }
  return corners;
}

FrontInput randomRegion(unsigned seed, double& size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  size = .04 + .12 * unit(random);
  FrontInput input;
  addLoop(input, divided(starShaped(random, {0, 0}, 1, .55), size));
  // Holes within the disc that every such polygon holds: around its centre, cut in sectors.
  const int holes = static_cast<int>(unit(random) * 4);
  for (int k = 0; k < holes; ++k) {
    const double t = 2 * M_PI * (k + .2 * unit(random)) / holes;
    const Point2 center = (holes == 1 ? 0 : .17) * Point2{std::cos(t), std::sin(t)};
    Points hole = divided(starShaped(random, center, .1, .5), size);
    std::reverse(hole.begin(), hole.end());
    addLoop(input, hole);
  }
  return input;
}

class RandomRegion : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomRegion, IsMeshedCompletely) {
  for (unsigned i = 0; i < 20; ++i) {
    const unsigned seed = 20 * GetParam() + i;
    SCOPED_TRACE("seed " + std::to_string(seed));
    double size = 0;
    const FrontInput input = randomRegion(seed, size);
    expectGoodMesh(meshFlat(input, size), input, 1e-3);
  }
}

/// Every side divided into parts whose lengths differ by up to `spread` squared.
Points dividedUnevenly(std::mt19937& random, const Points& corners, double size, double spread) {
  std::uniform_real_distribution<double> unit(0, 1);
  Points result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 p = corners[i], q = corners[(i + 1) % corners.size()];
    const double total = distance(p, q);
    for (double at = 0; at < total - 1e-12;) {
      result.push_back(p + (at / total) * (q - p));
      const double part = size * std::pow(spread, 2 * unit(random) - 1);
      at = at + 1.4 * part > total ? total : at + part;
    }
  }
  return result;
}

/// The classical set stops on needles that its score bound refuses at every level. With a last
/// level that takes every positive element and looks far, nothing is left over.
std::shared_ptr<const RuleSet> setWithLastResort() {
  RuleSetDefinition set = triangleSetDefinition();
  std::vector<double> bounds = byLevel(50, [](double q) { return 2 + .5 * q * q; });
  bounds.back() = 1e300;
  set.acceptance = std::make_shared<ScoreBound>(bounds);
  set.matchTolerance.back() = 400;
  return std::make_shared<RuleSet>(set);
}

TEST_P(RandomRegion, IsMeshedCompletelyWithALastResortHoweverUnevenItsBoundary) {
  const AF2Algorithm algorithm(setWithLastResort());
  for (unsigned i = 0; i < 10; ++i) {
    const unsigned seed = 10 * GetParam() + i;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const double size = .05 + .1 * std::uniform_real_distribution<double>(0, 1)(random);
    FrontInput input;
    const Points corners = starShaped(random, {0, 0}, 1, .6);
    addLoop(input, dividedUnevenly(random, corners, size, 8));
    expectGoodMesh(algorithm.execute(FlatMaker(), input, UniformSize(size)), input, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, RandomRegion, ::testing::Range(0u, 10u));

}  // namespace
}  // namespace af2
