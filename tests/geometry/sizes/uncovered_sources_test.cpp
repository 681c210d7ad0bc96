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
std::vector<SizeSource> steepSources(int count = 3000) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(0, 1);
  std::vector<SizeSource> sources;
  for (int i = 0; i < count; ++i) {
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

TEST(UncoveredSources, AreTheSameOnAnyThreads) {
  const std::vector<SizeSource> sources = steepSources(20000);
  EXPECT_TRUE(isSame(uncovered(sources, kGrowth, 3), uncovered(sources, kGrowth)));
}

TEST(GrowingSize, IsTheLeastOfAllSourcesOnAnyThreads) {
  const std::vector<SizeSource> sources = steepSources(20000);
  const auto leastAt = [&](const Point3& p) {
    double least = 1;
    for (const SizeSource& s : sources)
      least = std::min(least, s.size + kGrowth * distance(p, s.position));
    return least;
  };
  for (const int threads : {1, 3}) {
    const GrowingSize size(sources, kGrowth, 1, threads);
    for (const Point3& p : {Point3{}, {0.3, 0.4, 0}, {0.9, 0.1, 0.5}, {-2, 7, 1}})
      EXPECT_DOUBLE_EQ(size.at(p), leastAt(p));
  }
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
