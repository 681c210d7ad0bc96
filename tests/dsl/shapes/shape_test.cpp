#include "dsl/shapes/shape.h"

#include <gtest/gtest.h>

namespace af2::dsl {
namespace {

TEST(Fade, MovesEveryNumberInProportion) {
  const auto faded = fade(Shape::disc({0, 0}, 1) | Shape::hull({{0, 0}, {4, 0}, {0, 4}}),
                          Shape::disc({4, 8}, 3) | Shape::hull({{0, 0}, {0, 0}, {0, 0}}), 0.75);
  ASSERT_TRUE(faded);
  EXPECT_EQ(*faded, Shape::disc({1, 2}, 1.5) | Shape::hull({{0, 0}, {3, 0}, {0, 3}}));
}

TEST(Fade, MovesTheViaPointsOfArcs) {
  const auto faded = fade(Shape::poly({{{0, 0}, {}}, {{2, 0}, Point2{1, -1}}, {{1, 2}, {}}}),
                          Shape::poly({{{0, 0}, {}}, {{2, 0}, Point2{1, 0}}, {{1, 1}, {}}}), 0.5);
  ASSERT_TRUE(faded);
  EXPECT_EQ(*faded, Shape::poly({{{0, 0}, {}}, {{2, 0}, Point2{1, -0.5}}, {{1, 1.5}, {}}}));
}

TEST(Fade, GoesAllTheWayAtBothEnds) {
  const Shape p = Shape::grow(Shape::sector({0.1, 0.2}, 0.7, 0.3, 1.9), 0.4);
  const Shape l = Shape::grow(Shape::sector({0.9, 0.1}, 0.3, 0.1, 0.7), 0.1);
  EXPECT_EQ(*fade(p, l, 1), p);
  EXPECT_EQ(*fade(p, l, 0), l);
}

TEST(Fade, NeedsTheSameConstructors) {
  const Shape disc = Shape::disc({0, 0}, 1), hull = Shape::hull({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_FALSE(fade(disc, hull, 0.5));
  EXPECT_EQ(fadeMismatch(disc, hull), "a 'disc' cannot fade into a 'hull'");
  EXPECT_EQ(fadeMismatch(disc | disc, disc | hull), "a 'disc' cannot fade into a 'hull'");
  EXPECT_EQ(fadeMismatch(disc | disc, disc & disc), "a '|' cannot fade into a '&'");
  EXPECT_EQ(fadeMismatch(hull, Shape::hull({{0, 0}, {1, 0}})),
            "a 'hull' of 3 points cannot fade into one of 2");
  EXPECT_EQ(fadeMismatch(disc, disc), std::nullopt);
}

TEST(Fade, DoesNotBendStraightSteps) {
  const Shape arc = Shape::poly({{{0, 0}, {}}, {{2, 0}, Point2{1, -1}}, {{1, 2}, {}}});
  const Shape straight = Shape::poly({{{0, 0}, {}}, {{2, 0}, {}}, {{1, 2}, {}}});
  EXPECT_EQ(fadeMismatch(arc, straight), "a straight step of a 'poly' cannot fade into an arc");
  EXPECT_FALSE(fade(arc, straight, 0.5));
}

TEST(IsBounded, IsTrueOfWhatHasNoHalfPlane) {
  EXPECT_TRUE(isBounded(Shape::disc({0, 0}, 1) | Shape::sector({9, 9}, 2, 0, 4)));
}

TEST(IsBounded, IsFalseOfHalfPlanesQuadrantsStripsAndRays) {
  const Shape up = Shape::left({0, 0}, {1, 0}), right = Shape::left({0, 0}, {0, -1});
  const Shape below = Shape::left({0, 1}, {-1, 0}), disc = Shape::disc({0, 0}, 5);
  EXPECT_FALSE(isBounded(up));
  EXPECT_FALSE(isBounded(up & right));
  EXPECT_FALSE(isBounded(up & below));
  EXPECT_FALSE(isBounded(up & below & right));
  EXPECT_FALSE(isBounded(up | disc));
  EXPECT_FALSE(isBounded(up - disc));
  EXPECT_FALSE(isBounded(Shape::grow(up & right, 0.1)));
}

TEST(IsBounded, IsTrueOfHalfPlanesThatCloseUp) {
  const Shape up = Shape::left({0, 0}, {1, 0}), right = Shape::left({0, 0}, {0, -1});
  const Shape slanted = Shape::left({1, 0}, {-1, 1}), disc = Shape::disc({0, 0}, 5);
  EXPECT_TRUE(isBounded(up & right & slanted));
  EXPECT_TRUE(isBounded(up & disc));
  EXPECT_TRUE(isBounded(disc - up));
  EXPECT_TRUE(isBounded(up - Shape::left({0, -1}, {1, 0})));
  EXPECT_TRUE(isBounded(up & Shape::left({0, 0}, {-1, 0})));   // a line: no area
  EXPECT_TRUE(isBounded(up & Shape::left({0, -1}, {-1, 0})));  // empty
}

}  // namespace
}  // namespace af2::dsl
