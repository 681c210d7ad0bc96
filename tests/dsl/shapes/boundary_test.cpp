#include "dsl/shapes/boundary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dsl/shapes/shape.h"
#include "random_shapes.h"

namespace af2::dsl {
namespace {

double areaOf(const std::vector<std::vector<Point2>>& loops) {
  double area = 0;
  for (const auto& loop : loops)
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++)
      area += 0.5 * cross(loop[j], loop[i]);
  return area;
}

TEST(Outline, OfAPolygonIsItsCorners) {
  const auto loops = outline(Shape::hull({{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].size(), 4u);
  EXPECT_EQ(areaOf(loops), 2);
}

TEST(Outline, OfADiscIsFine) {
  EXPECT_NEAR(areaOf(outline(Shape::disc({1, 2}, 3), 1e-6)), 9 * M_PI, 1e-2);
}

TEST(Outline, ShowsHoles) {
  const auto loops = outline(Shape::disc({0, 0}, 2) - Shape::hull({{0, 0}, {1, 0}, {0, 1}}), 1e-6);
  EXPECT_EQ(loops.size(), 2u);
  EXPECT_NEAR(areaOf(loops), 4 * M_PI - 0.5, 1e-2);
}

TEST(Outline, HasNoSeams) {
  const Shape both =
      Shape::hull({{0, 0}, {1, 0}, {1, 1}, {0, 1}}) | Shape::hull({{1, 0}, {2, 0}, {2, 1}, {1, 1}});
  const auto loops = outline(both);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(areaOf(loops), 2);
}

TEST(Outline, FollowsArcs) {
  const Shape halfDisc = Shape::poly({{{5, 0}, {}}, {{-5, 0}, Point2{3, 4}}});
  const auto loops = outline(halfDisc, 1e-6);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(areaOf(loops), 12.5 * M_PI, 1e-2);
}

TEST(Outline, ClipsHalfPlanes) {
  const auto loops = outline(Shape::disc({0, 0}, 1) & Shape::left({0, 0}, {1, 1}), 1e-6);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(areaOf(loops), M_PI / 2, 1e-3);
}

/// A zone that is no shape of the language.
class DiamondZone final : public AF2FreeZone {
 public:
  Box2 boundingBox() const override { return {{-1, -1}, {1, 1}}; }
  bool contains(Point2 p, ZoneBoundary) const override { return std::abs(p.x) + std::abs(p.y) < 1; }
  bool meets(Point2, Point2, ZoneBoundary) const override { return false; }
};

TEST(Outline, OfAUsersZoneIsTraced) {
  const auto loops = outline(DiamondZone());
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(areaOf(loops), 2, 0.05);
}

TEST(Outline, OfAZoneIsThatOfItsShape) {
  const Shape shape = Shape::disc({0, 0}, 2) - Shape::hull({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_EQ(outline(*makeZone(shape).zone), outline(shape));
}

TEST(Outline, EnclosesWhatTheZoneContains) {
  SCOPED_TRACE(test::seedNote());
  test::RandomShapes random(test::seedOfRun() + 20);
  for (int i = 0; i < 100; ++i) {
    const Shape shape = random.shape(i % 3) & Shape::hull({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
    const MadeZone zone = makeZone(shape);
    const auto loops = outline(shape, 1e-5);
    int inside = 0;
    constexpr int kGrid = 100;
    for (int x = 0; x < kGrid; ++x)
      for (int y = 0; y < kGrid; ++y)
        inside += zone.zone->contains({4 * (x + 0.5) / kGrid - 2, 4 * (y + 0.5) / kGrid - 2},
                                      ZoneBoundary::Counts);
    EXPECT_NEAR(areaOf(loops), inside * 16.0 / (kGrid * kGrid), 0.15) << i;
  }
}

}  // namespace
}  // namespace af2::dsl
