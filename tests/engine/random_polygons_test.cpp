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

INSTANTIATE_TEST_SUITE_P(Meshes, RandomRegion, ::testing::Range(0u, 10u));

}  // namespace
}  // namespace af2
