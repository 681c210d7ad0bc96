#include "geometry/sizes/uncovered_sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace af2::geometry {
namespace {

constexpr double kGrowth = 0.2;

bool isSame(const std::vector<SizeSource>& one, const std::vector<SizeSource>& other) {
  return std::ranges::equal(one, other, [](const SizeSource& a, const SizeSource& b) {
    return a.position == b.position && a.size == b.size;
  });
}

/// Places in a square whose sizes grow steeply from a corner.
std::vector<SizeSource> steepSources() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(0, 1);
  std::vector<SizeSource> sources;
  for (int i = 0; i < 3000; ++i) {
    const Point3 place{at(random), at(random), 0};
    sources.push_back({place, 0.01 + 0.5 * length(place)});
  }
  return sources;
}

TEST(UncoveredSources, LeaveTheSameAsAllSources) {
  UncoveredSources some(kGrowth);
  std::size_t left = 0;
  for (const SizeSource& source : steepSources()) {
    if (left % 100 == 0) some.sort();
    if (some.cover(source)) continue;
    some.add(source);
    ++left;
  }
  EXPECT_LT(left, steepSources().size() / 4);
  const auto all = uncovered(steepSources(), kGrowth);
  EXPECT_TRUE(isSame(uncovered(some.take(), kGrowth), all));
}

TEST(UncoveredSources, AreNotCoveredByThemselvesOrByEqualOnes) {
  const SizeSource source{{1, 2, 3}, 0.5};
  UncoveredSources sources(kGrowth);
  EXPECT_FALSE(sources.cover(source));
  sources.add(source);
  EXPECT_FALSE(sources.cover(source));
  sources.sort();
  EXPECT_FALSE(sources.cover(source));
  EXPECT_TRUE(sources.cover({{1, 2, 3.1}, 0.6}));
  EXPECT_FALSE(sources.cover({{1, 2, 4}, 0.6}));
}

}  // namespace
}  // namespace af2::geometry
