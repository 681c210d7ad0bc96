#include "geometry/retry/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "geometry/retry/retry_limits.h"

namespace af2::geometry {
namespace {

constexpr double kGrowth = 0.3, kLargest = 1;

/// Places in a unit cube with sizes from a hundredth to the largest.
std::vector<SizeSource> randomPlaces(std::size_t count) {
  std::mt19937 generator(1);
  const auto next = [&] { return generator() / 4294967296.0; };
  std::vector<SizeSource> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = next(), y = next(), z = next();
    places.push_back({{x, y, z}, 0.01 + 0.99 * next() * next()});
  }
  return places;
}

double sizeAmong(const std::vector<SizeSource>& places, const Point3& at) {
  double least = kLargest;
  for (const SizeSource& place : places)
    least = std::min(least, place.size + kGrowth * distance(place.position, at));
  return least;
}

TEST(Refinement, GivesEachOfThousandsOfPlacesAboutTheSizeThatItRequests) {
  const std::vector<SizeSource> places = randomPlaces(6000);
  Refinement refinement({}, kGrowth, kLargest);
  refinement.add(3, places);
  const PositionSize sizes = refinement.sizes();
  for (std::size_t i = 0; i < places.size(); i += 7) {
    const Point3& at = places[i].position;
    const double wanted = sizeAmong(places, at), given = sizes.at(at);
    EXPECT_LE(given, kClearlySmaller * wanted * (1 + 1e-12));
    EXPECT_GE(given, wanted * (1 - 1e-12));
  }
}

TEST(Refinement, ReducesSizesToThoseThatItGives) {
  const std::vector<SizeSource> places = randomPlaces(1000);
  Refinement refinement([](const Point3& p) { return p.x < 0.5 ? 0.05 : 2.0; }, kGrowth, kLargest);
  refinement.add(0, places);
  const PositionSize sizes = refinement.sizes();
  for (const SizeSource& place : places) {
    for (const double before : {0.02, 0.3, std::numeric_limits<double>::infinity()}) {
      double size = before;
      sizes.lower({&place.position, 1}, {&size, 1});
      EXPECT_EQ(size, std::min(before, sizes.at(place.position)));
    }
  }
}

}  // namespace
}  // namespace af2::geometry
