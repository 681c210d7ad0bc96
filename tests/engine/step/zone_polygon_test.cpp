#include "engine/step/zone_polygon.h"

#include <gtest/gtest.h>

#include <random>

namespace af2 {
namespace {

/// A zone whose corners are given outright.
FastZone zoneOf(const std::vector<Point2>& corners) {
  AffineBatch batch;
  for (Point2 p : corners) batch.add(AffinePointTransform(p, {}), 2);
  return {{batch}};
}

constexpr Point2 kBase[2]{{0, 0}, {1, 0}};

/// Holds every answer of the fast form against the open form.
void expectSameAnswers(const std::vector<Point2>& corners, const std::vector<Point2>& points) {
  ZonePolygon fast;
  const bool isZone = fast.make(zoneOf(corners), 1, kBase);
  ASSERT_EQ(isZone, ConvexPolygonZone::isConvex(corners));
  if (!isZone) return;
  const ConvexPolygonZone open(corners);
  for (const ZoneBoundary boundary : {ZoneBoundary::Counts, ZoneBoundary::Ignored}) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point2 p = points[i], q = points[(7 * i + 3) % points.size()];
      ASSERT_EQ(fast.contains(p, boundary), open.contains(p, boundary)) << p.x << " " << p.y;
      ASSERT_EQ(fast.meets(p, q, boundary), open.meets(p, q, boundary))
          << p.x << " " << p.y << " -> " << q.x << " " << q.y;
    }
  }
}

std::vector<Point2> randomCorners(std::mt19937& random, int count, double irregularity) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point2> corners;
  const double start = 6 * unit(random);
  for (int k = 0; k < count; ++k) {
    const double angle = start + 2 * M_PI * (k + irregularity * unit(random)) / count;
    corners.push_back({0.5 + std::cos(angle), 0.4 + std::sin(angle)});
  }
  return corners;
}

TEST(ZonePolygon, AnswersAsTheOpenFormAtScatteredPoints) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-2, 3);
  for (int n = 0; n < 300; ++n) {
    std::vector<Point2> points;
    for (int i = 0; i < 40; ++i) points.push_back({coordinate(random), coordinate(random)});
    expectSameAnswers(randomCorners(random, 3 + n % 6, n % 2), points);
  }
}

TEST(ZonePolygon, AnswersAsTheOpenFormWhereThingsTouch) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int n = 0; n < 300; ++n) {
    const std::vector<Point2> corners = randomCorners(random, 3 + n % 6, 0.9);
    // Corners, points on the sides up to rounding, and points far out along them.
    std::vector<Point2> points = corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point2 p = corners[k], side = corners[(k + 1) % corners.size()] - p;
      for (const double t : {0.5, unit(random), 1 + unit(random), -unit(random), 1e6})
        points.push_back(p + t * side);
    }
    expectSameAnswers(corners, points);
  }
}

TEST(ZonePolygon, AnswersAsTheOpenFormOnAGrid) {
  std::mt19937 random(6);
  std::uniform_int_distribution<int> coordinate(-2, 2);
  std::vector<Point2> grid;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y) grid.push_back({0.5 * x, 0.5 * y});
  int zones = 0;
  for (int n = 0; n < 3000; ++n) {
    std::vector<Point2> corners;
    for (int k = 0; k < 3 + n % 4; ++k)
      corners.push_back({0.5 * coordinate(random), 0.5 * coordinate(random)});
    zones += ConvexPolygonZone::isConvex(corners);
    expectSameAnswers(corners, grid);
  }
  EXPECT_GT(zones, 100);
}

TEST(ZonePolygon, IsNoZoneThatGoesRoundTwice) {
  std::vector<Point2> pentagram;
  for (int k = 0; k < 5; ++k)
    pentagram.push_back({std::cos(0.8 * M_PI * k), std::sin(0.8 * M_PI * k)});
  ZonePolygon zone;
  EXPECT_FALSE(zone.make(zoneOf(pentagram), 1, kBase));
  EXPECT_FALSE(zone.make(zoneOf({{0, 0}, {0, 1}, {1, 1}}), 1, kBase)) << "clockwise";
}

TEST(ZonePolygon, IsExactForVerySmallAndVeryLargeZones) {
  for (const double scale : {1e-200, 1e-30, 1e30, 1e100}) {
    const auto at = [&](double x, double y) { return Point2{scale * x, scale * y}; };
    std::vector<Point2> points;
    for (int x = -2; x <= 3; ++x)
      for (int y = -2; y <= 3; ++y) points.push_back(at(0.5 * x, 0.5 * y));
    expectSameAnswers({at(0, 0), at(1, 0), at(1, 1), at(0, 1)}, points);
  }
}

}  // namespace
}  // namespace af2
