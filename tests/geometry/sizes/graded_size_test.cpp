#include "geometry/sizes/graded_size.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/support/flat_surface.h"

namespace af2::geometry {
namespace {

TEST(GrowingSize, IsTheSmallestOfWhatGrowsFromItsSources) {
  const std::vector<SizeSource> sources{{{0, 0, 0}, 0.1}, {{1, 0, 0}, 0.2}, {{0, 3, 1}, 0.05}};
  const GrowingSize size(sources, 0.4, 1.0);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-4, 4);
  for (int i = 0; i < 1000; ++i) {
    const Point3 p{any(random), any(random), any(random)};
    double expected = 1;
    for (const SizeSource& s : sources)
      expected = std::min(expected, s.size + 0.4 * distance(s.position, p));
    EXPECT_DOUBLE_EQ(size.at(p), expected);
  }
}

TEST(GrowingSize, FindsTheSmallestAmongManyBalls) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 10), some(0.01, 0.5);
  std::vector<SizeSource> sources;
  for (int i = 0; i < 777; ++i)
    sources.push_back({{any(random), any(random), any(random)}, some(random), some(random)});
  const GrowingSize size(sources, 0.3, 2);
  for (int i = 0; i < 300; ++i) {
    const Point3 p{2 * any(random) - 5, any(random), any(random)};
    double expected = 2;
    for (const SizeSource& s : sources) {
      const double outside = std::max(0.0, distance(s.position, p) - s.radius);
      expected = std::min(expected, s.size + 0.3 * outside);
    }
    EXPECT_EQ(size.at(p), expected);
  }
}

TEST(GrowingSize, LowersSizesAlongALineToExactlyThoseOfSinglePlaces) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(0, 10), some(0.01, 0.5), factor(0.5, 1.5);
  std::vector<SizeSource> sources;
  for (int i = 0; i < 777; ++i)
    sources.push_back({{any(random), any(random), any(random)}, some(random), some(random) / 10});
  const GrowingSize size(sources, 0.3, 2);
  std::size_t lowered = 0, kept = 0;
  for (int line = 0; line < 40; ++line) {
    const Point3 from{any(random), any(random), any(random)}, way{any(random), any(random), 0};
    std::vector<Point3> at;
    std::vector<double> sizes;
    for (int i = 0; i < 100; ++i) {
      at.push_back(from + 1e-3 * i * way);
      sizes.push_back(factor(random) * size.at(at.back()));
    }
    std::vector<double> expected;
    for (std::size_t i = at.size(); i-- > 0;)
      expected.insert(expected.begin(), std::min(sizes[i], size.at(at[i])));
    const std::vector<double> before = sizes;
    size.lower(at, sizes);
    EXPECT_EQ(sizes, expected);
    for (std::size_t i = 0; i < at.size(); ++i) ++(sizes[i] < before[i] ? lowered : kept);
  }
  EXPECT_GT(lowered, 1000u);
  EXPECT_GT(kept, 1000u);
}

TEST(GrowingSize, NeedsOnlyTheUncoveredSources) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 10), some(0.01, 1), radius(0, 0.2);
  std::vector<SizeSource> sources;
  for (int i = 0; i < 1000; ++i)
    sources.push_back({{any(random), any(random), 0}, some(random), radius(random)});
  const std::vector<SizeSource> few = uncovered(sources, 0.3);
  EXPECT_GT(few.size(), 10u);
  EXPECT_LT(few.size(), 500u);
  const GrowingSize all(sources, 0.3, 5), same(few, 0.3, 5);
  for (int i = 0; i < 1000; ++i) {
    const Point3 p{2 * any(random) - 5, any(random), any(random) - 5};
    EXPECT_EQ(same.at(p), all.at(p));
  }
}

FrontInput polygon(const std::vector<Point2>& corners) {
  FrontInput input;
  testing::addLoop(input, corners);
  return input;
}

FrontInput rectangle(double width, double height) {
  return polygon({{0, 0}, {width, 0}, {width, height}, {0, height}});
}

TEST(GradedSize, IsAsWantedFarFromShortSegments) {
  const UniformSize wanted(10);
  const GradedSize size(wanted, polygon({{0, 0}, {0.01, 0}, {0.02, 0}, {10, 0}, {10, 10}}), 1);
  EXPECT_NEAR(size.sizeAt({{0.01, 0, 0}, {}}), 0.01, 1e-12);
  EXPECT_NEAR(size.sizeAt({{0.01, 0.4, 0}, {}}), 0.41, 1e-12);
  EXPECT_EQ(size.sizeAt({{10, 10, 0}, {}}), 10);
}

TEST(GradedSize, ComesDownFromLongSegmentsInSteps) {
  const UniformSize wanted(1);
  const GradedSize size(wanted, rectangle(8, 8), 0.5);
  EXPECT_EQ(size.sizeAt({{4, 0, 0}, {}}), 8);
  EXPECT_EQ(size.sizeAt({{4, 4, 0}, {}}), 4);
  EXPECT_EQ(size.sizeAt({{4, -6, 0}, {}}), 2);
  EXPECT_EQ(size.sizeAt({{4, -20, 0}, {}}), 1);
}

TEST(GradedSize, IsTheSameOverAnotherFieldWithTheSameSizes) {
  const SizeFunction wanted([](const Point3& p) { return 1 + p.x; });
  const SizeFunction alike([](const Point3& p) { return 1 + p.x; });
  const GradedSize size(wanted, rectangle(8, 0.1), 0.5), other(alike, size);
  for (double x = 0; x <= 8; x += 0.25)
    EXPECT_EQ(other.sizeAt({{x, 0.05, 0}, {}}), size.sizeAt({{x, 0.05, 0}, {}}));
}

/// The size at a corner is asked for many times, and each evaluation of a surface is expensive.
TEST(GradedSize, EvaluatesTheWantedSizeAtACornerOnce) {
  int evaluations = 0;
  const SizeFunction wanted([&](const Point3& p) {
    ++evaluations;
    return 1 + p.x;
  });
  const FrontInput boundary = rectangle(8, 0.1);
  const GradedSize size(wanted, boundary, 0.5);
  const UngradedSize ungraded(size);
  EXPECT_EQ(evaluations, 4);
  for (const BoundaryCorner& corner : boundary.loops[0]) {
    EXPECT_EQ(ungraded.sizeAt(corner.point), 1 + corner.point.position.x);
    EXPECT_LE(size.sizeAt(corner.point), 9);
  }
  EXPECT_EQ(evaluations, 4);
  EXPECT_EQ(ungraded.sizeAt({{4, 0.05, 0}, {}}), 5);
  EXPECT_EQ(evaluations, 5);
}

/// Corners with one place and different parameters are different: surfaces may bend otherwise.
TEST(GradedSize, KnowsCornersByPlaceAndParameters) {
  struct ByParameter final : SizeField {
    double sizeAt(const SurfacePoint& point) const override { return 1 + point.u; }
  };
  const ByParameter wanted;
  FrontInput boundary = rectangle(8, 8);
  const GradedSize size(wanted, boundary, 0.5);
  SurfacePoint other = boundary.loops[0][0].point;
  EXPECT_EQ(UngradedSize(size).sizeAt(other), 1);
  other.u = 2;
  EXPECT_EQ(UngradedSize(size).sizeAt(other), 3);
}

/// A file may have such coordinates; others tell of them.
TEST(GradedSize, CopesWithCornersThatAreNoNumbers) {
  const UniformSize wanted(1);
  FrontInput boundary = rectangle(8, 8);
  boundary.loops[0][1].point.position.x = std::numeric_limits<double>::quiet_NaN();
  const GradedSize size(wanted, boundary, 0.5);
  EXPECT_EQ(UngradedSize(size).sizeAt(boundary.loops[0][1].point), 1);
  EXPECT_GE(size.sizeAt(boundary.loops[0][0].point), 1);
}

TEST(GradedSize, LeavesAnEvenBoundaryAlone) {
  const UniformSize wanted(1);
  EXPECT_EQ(GradedSize(wanted, rectangle(0.8, 0.8), 0.5).sizeAt({{0, 0, 0}, {}}), 1);
}

}  // namespace
}  // namespace af2::geometry
