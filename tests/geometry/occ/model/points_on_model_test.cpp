#include "geometry/occ/model/points_on_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "engine/base/error.h"
#include "tests/geometry/occ/shapes.h"

namespace af2::geometry {
namespace {

Model cylinder() { return testing::cylinder(2, 5); }

int faceOf(const Model& model, const std::string& type) {
  for (int face = 1; face <= model.faceCount(); ++face)
    if (model.surfaceType(face) == type) return face;
  return 0;
}

PointOnModel nearestTo(const Model& model, const Point3& p) {
  return nearestPoints(model, std::vector<Point3>{p}).front();
}

TEST(PointsOnModel, AreFeetOfPerpendiculars) {
  const Model model = cylinder();
  const PointOnModel found = nearestTo(model, {3, 0, 1});
  EXPECT_NEAR(distance(found.point.position, {2, 0, 1}), 0, 1e-9);
  EXPECT_NEAR(distance(found.point.normal, {1, 0, 0}), 0, 1e-9);
  EXPECT_NEAR(found.distance, 1, 1e-9);
  EXPECT_EQ(found.face, faceOf(model, "cylinder"));
}

TEST(PointsOnModel, AreOnEdgesBeyondThem) {
  const PointOnModel found = nearestTo(cylinder(), {4, 0, 6});
  EXPECT_NEAR(distance(found.point.position, {2, 0, 5}), 0, 1e-7);
}

TEST(PointsOnModel, AreOnTheFaceThatIsAskedFor) {
  const Model model = cylinder();
  const int side = faceOf(model, "cylinder");
  const std::vector<Point3> points{{0.5, 0, 7}};
  const PointOnModel found = nearestPoints(model, points, std::vector<int>{side}).front();
  EXPECT_EQ(found.face, side);
  EXPECT_NEAR(distance(found.point.position, {2, 0, 5}), 0, 1e-7);
  EXPECT_NE(nearestTo(model, points.front()).face, side);
}

TEST(PointsOnModel, AreNoFartherThanAnyPointOfTheModel) {
  const Model model = testing::box(1, 2, 3);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-2, 5);
  std::vector<Point3> points(300);
  for (Point3& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
  const auto found = nearestPoints(model, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    const Point3 inBox{std::clamp(p.x, 0., 1.), std::clamp(p.y, 0., 2.), std::clamp(p.z, 0., 3.)};
    const double toWall =
        std::min({inBox.x, 1 - inBox.x, inBox.y, 2 - inBox.y, inBox.z, 3 - inBox.z});
    const double expected = p == inBox ? toWall : distance(p, inBox);
    EXPECT_NEAR(found[i].distance, expected, 1e-7);
    EXPECT_NEAR(distance(found[i].point.position, p), expected, 1e-7);
  }
}

TEST(PointsOnModel, DoNotDependOnThreads) {
  const Model model = cylinder();
  std::vector<Point3> points;
  for (int i = 0; i < 2000; ++i) points.push_back({std::cos(i), std::sin(2 * i), 0.003 * i});
  const auto alone = nearestPoints(model, points, {}, 1);
  const auto together = nearestPoints(model, points, {}, 4);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(alone[i].point.position, together[i].point.position);
}

TEST(PointsOnModel, ComeBackFromTheirParameters) {
  const Model model = cylinder();
  const int side = faceOf(model, "cylinder");
  const PointOnModel found = nearestTo(model, {1.5, -2, 2});
  const auto again =
      pointsAt(model, side, std::vector<Point2>{{found.point.u, found.point.v}}).front();
  EXPECT_NEAR(distance(again.point.position, found.point.position), 0, 1e-9);
  EXPECT_NEAR(distance(again.point.normal, found.point.normal), 0, 1e-9);
}

TEST(PointsOnModel, RefuseWhatTheModelDoesNotHave) {
  const Model model = cylinder();
  EXPECT_THROW(pointsAt(model, 4, {}), InputError);
  EXPECT_THROW(pointsAt(model, 1, std::vector<Point2>{{NAN, 0}}), InputError);
  const std::vector<Point3> point{{0, 0, 0}};
  EXPECT_THROW(nearestPoints(model, point, std::vector<int>{9}), InputError);
  EXPECT_THROW(nearestPoints(model, point, std::vector<int>{1, 1}), InputError);
  EXPECT_THROW(nearestPoints(model, std::vector<Point3>{{0, INFINITY, 0}}), InputError);
}

}  // namespace
}  // namespace af2::geometry
