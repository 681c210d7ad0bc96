// That rings are filled with the fewest irregular vertices, without gaps and overlaps.
#include "engine/optimize/ring_filling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace af2 {
namespace {

/// A regular polygon whose sides are divided; all of its vertices may change.
Ring ringOf(const std::vector<int>& sides) {
  Ring ring;
  const auto corner = [&](std::size_t i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(sides.size());
    return 4 * Point2{std::cos(angle), std::sin(angle)};
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    ring.corners.push_back(ring.points.size());
    for (int k = 0; k < sides[i]; ++k)
      ring.points.push_back(corner(i) + (1.0 * k / sides[i]) * (corner(i + 1) - corner(i)));
  }
  ring.mayChange.assign(ring.points.size(), 1);
  return ring;
}

double areaOf(const std::vector<Point2>& points) {
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    twice += cross(points[i], points[(i + 1) % points.size()]);
  return 0.5 * twice;
}

/// How many vertices inside have other than four quadrilaterals, and vertices of the ring others
/// than their corners ask for.
int countIrregular(const Ring& ring, const RingFilling& filling) {
  std::vector<int> count(filling.points.size(), 0);
  for (const auto& quad : filling.quads)
    for (const std::size_t v : quad) ++count[v];
  int irregular = 0;
  for (std::size_t v = 0; v < count.size(); ++v) {
    const bool isCorner = std::ranges::count(ring.corners, v) > 0;
    const int wanted = v >= ring.points.size() ? 4 : isCorner ? 1 : 2;
    irregular += count[v] != wanted ? 1 : 0;
  }
  return irregular;
}

/// Each side belongs to two quadrilaterals, or to one and the ring, in opposite directions.
void expectFilled(const Ring& ring, const RingFilling& filling) {
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  const std::size_t n = ring.points.size();
  for (std::size_t i = 0; i < n; ++i) ++sides[{(i + 1) % n, i}];
  double area = 0;
  for (const auto& quad : filling.quads) {
    std::vector<Point2> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      ++sides[{quad[i], quad[(i + 1) % 4]}];
      corners.push_back(filling.points[quad[i]]);
    }
    area += areaOf(corners);
  }
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(sides.count({side.second, side.first}) == 1);
  }
  EXPECT_NEAR(area, areaOf(ring.points), 1e-9);
}

/// The number of irregular vertices of the best plan; -1: there is none.
int irregularIn(const std::vector<int>& sides, int most = 4) {
  const Ring ring = ringOf(sides);
  const std::vector<FillingPlan> plans = fillingPlans(ring, most, 5);
  for (const FillingPlan& plan : plans) {
    const RingFilling filling = fillRing(ring, plan);
    expectFilled(ring, filling);
    EXPECT_EQ(countIrregular(ring, filling), plan.irregular);
    EXPECT_GE(plan.irregular, plans.front().irregular);
  }
  return plans.empty() ? -1 : plans.front().irregular;
}

TEST(RingFilling, MakesAGridOfEqualOppositeSides) {
  EXPECT_EQ(irregularIn({3, 4, 3, 4}), 0);
  EXPECT_EQ(irregularIn({1, 1, 1, 1}), 0);
}

TEST(RingFilling, MakesAStarOfThreeOrFiveSides) {
  EXPECT_EQ(irregularIn({2, 2, 2}), 1);
  EXPECT_EQ(irregularIn({3, 4, 5}), 1);
  EXPECT_EQ(irregularIn({2, 2, 2, 2, 2}), 1);
  EXPECT_EQ(irregularIn({3, 4, 4, 3, 4}), 1);
}

TEST(RingFilling, MakesTwoStarsWhereOppositeSidesDiffer) {
  EXPECT_EQ(irregularIn({4, 4, 5, 5}), 2);
  EXPECT_EQ(irregularIn({4, 5, 4, 7}), 2);
  EXPECT_EQ(irregularIn({4, 4}), 2);
  EXPECT_EQ(irregularIn({2, 2, 2, 2, 2, 2}), 2);
}

/// Three sides of which one is longer than the others together: a corner is added or removed.
TEST(RingFilling, ChangesCornersWhereNoStarFits) {
  EXPECT_GT(irregularIn({2, 2, 6}), 1);
  EXPECT_GT(irregularIn({4, 4, 4, 4, 4, 12}), 1);
}

TEST(RingFilling, KeepsCornersThatMayNotChange) {
  Ring ring = ringOf({2, 2, 6});
  ring.mayChange.assign(ring.points.size(), 0);
  EXPECT_TRUE(fillingPlans(ring, 4, 5).empty());
}

TEST(RingFilling, NeedsAnEvenNumberOfEdges) { EXPECT_EQ(irregularIn({2, 2, 3}), -1); }

TEST(RingFilling, LeavesOutWhatIsNoBetter) {
  EXPECT_EQ(irregularIn({2, 2, 2}, 0), -1);
  EXPECT_EQ(irregularIn({4, 4, 5, 5}, 1), -1);
}

}  // namespace
}  // namespace af2
