// Zones of shapes at their boundaries: what touches, what enters.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dsl/shapes/shape.h"

namespace af2::dsl {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

Shape rectangle(Point2 low, Point2 high) {
  return Shape::hull({low, {high.x, low.y}, high, {low.x, high.y}});
}

/// An L: the unit square below, half of it above.
const Shape kEll = Shape::poly(
    {{{0, 0}, {}}, {{2, 0}, {}}, {{2, 1}, {}}, {{1, 1}, {}}, {{1, 2}, {}}, {{0, 2}, {}}});

bool isIn(const Shape& shape, Point2 p) {
  return makeZone(shape).zone->contains(p, ZoneBoundary::Ignored);
}
bool isInOrOn(const Shape& shape, Point2 p) {
  return makeZone(shape).zone->contains(p, ZoneBoundary::Counts);
}
bool isOn(const Shape& shape, Point2 p) { return isInOrOn(shape, p) && !isIn(shape, p); }
bool enters(const Shape& shape, Point2 p, Point2 q) {
  return makeZone(shape).zone->meets(p, q, ZoneBoundary::Ignored);
}
bool touches(const Shape& shape, Point2 p, Point2 q) {
  return makeZone(shape).zone->meets(p, q, ZoneBoundary::Counts);
}

Point2 up(Point2 p) { return {p.x, std::nextafter(p.y, 1e9)}; }
Point2 down(Point2 p) { return {p.x, std::nextafter(p.y, -1e9)}; }

TEST(PolyZone, TellsTheNotchFromTheInside) {
  EXPECT_TRUE(isIn(kEll, {0.5, 1.5}));
  EXPECT_TRUE(isIn(kEll, {1.5, 0.5}));
  EXPECT_FALSE(isInOrOn(kEll, {1.5, 1.5}));
  EXPECT_TRUE(isOn(kEll, {1, 1}));
  EXPECT_TRUE(isOn(kEll, {1, 1.5}));
  EXPECT_TRUE(isIn(kEll, {1, 0.5}));
}

TEST(PolyZone, IsMetThroughTheReflexCornerOnlyIfEntered) {
  EXPECT_FALSE(enters(kEll, {1, 2.5}, {1, 1}));        // down the inner side
  EXPECT_TRUE(enters(kEll, {1, 2.5}, {1, 0.999}));     // past the corner
  EXPECT_FALSE(enters(kEll, {1, 1}, {2, 2}));          // away from the corner
  EXPECT_TRUE(enters(kEll, {2, 2}, {0, 0}));           // in through the corner
  EXPECT_FALSE(enters(kEll, {1, 3}, {3, 1}));          // across the notch
  EXPECT_TRUE(enters(kEll, {1, 2}, {2, 1}) == false);  // from corner to corner across it
  EXPECT_TRUE(enters(kEll, {0.5, 1.5}, {1.5, 0.5}));   // both ends inside, corner touched between
}

TEST(PolyZone, IsNotMetAlongItsOutside) {
  EXPECT_FALSE(enters(kEll, {-1, 0}, {3, 0}));
  EXPECT_FALSE(enters(kEll, {2, -1}, {2, 5}));
  EXPECT_TRUE(touches(kEll, {2, -1}, {2, 5}));
  EXPECT_FALSE(touches(kEll, {up({2, 2}).x, 2}, {3, 3}));
}

TEST(PolyZone, DecidesByTheLastBit) {
  EXPECT_FALSE(enters(kEll, {1.2, 1}, {1.8, 1}));
  EXPECT_TRUE(enters(kEll, {1.2, 1}, down({1.8, 1})));
  EXPECT_FALSE(enters(kEll, {1.2, 1}, up({1.8, 1})));
  EXPECT_TRUE(isOn(kEll, {1.5, 1}));
  EXPECT_TRUE(isIn(kEll, down({1.5, 1})));
  EXPECT_FALSE(isInOrOn(kEll, up({1.5, 1})));
}

TEST(DiscZone, IsClosedForPointsAndOpenForEdges) {
  const Shape disc = Shape::disc({1, 1}, 5);
  EXPECT_TRUE(isOn(disc, {4, 5}));
  EXPECT_FALSE(isInOrOn(disc, up({4, 5})));
  EXPECT_TRUE(isIn(disc, down({4, 5})));
  EXPECT_FALSE(enters(disc, {-9, 6}, {9, 6}));  // tangent
  EXPECT_TRUE(touches(disc, {-9, 6}, {9, 6}));
  EXPECT_FALSE(touches(disc, {1.5, 6}, {9, 6}));  // beyond the point of contact
  EXPECT_TRUE(enters(disc, {-9, 6}, down({9, 6})));
  EXPECT_FALSE(touches(disc, up({-9, 6}), up({9, 6})));
}

TEST(DiscZone, ToleratesATangentInAnyDirection) {
  const Shape disc = Shape::disc({0, 0}, 5);  // tangent at (3, 4): 3 x + 4 y = 25
  EXPECT_FALSE(enters(disc, {-1, 7}, {7, 1}));
  EXPECT_TRUE(touches(disc, {-1, 7}, {7, 1}));
  EXPECT_TRUE(enters(disc, {-1, 7}, down({7, 1})));
  EXPECT_FALSE(touches(disc, {-1, 7}, up({7, 1})));
}

TEST(DiscZone, IsMetByAnEdgeInside) {
  EXPECT_TRUE(enters(Shape::disc({0, 0}, 5), {-1, 0}, {1, 0}));
  EXPECT_TRUE(enters(Shape::disc({0, 0}, 5), {3, 4}, {-3, 4}));  // a chord
  EXPECT_FALSE(enters(Shape::disc({0, 0}, 5), {3, 4}, {6, 8}));
}

TEST(SectorZone, HasExactFlanksAtQuarterTurns) {
  const Shape quadrant = Shape::sector({0, 0}, 5, 0, M_PI / 2);
  EXPECT_TRUE(isOn(quadrant, {1, 0}));
  EXPECT_TRUE(isOn(quadrant, {0, 5}));
  EXPECT_TRUE(isOn(quadrant, {3, 4}));
  EXPECT_TRUE(isIn(quadrant, {1, 1}));
  EXPECT_FALSE(isInOrOn(quadrant, {-1e-300, 1}));
  EXPECT_FALSE(enters(quadrant, {0, -9}, {0, 9}));
}

TEST(SectorZone, MayBeWiderThanAHalfTurnOrWhole) {
  const Shape wide = Shape::sector({0, 0}, 1, 0, 1.5 * M_PI);
  EXPECT_TRUE(isIn(wide, {-0.5, -0.5}));
  EXPECT_FALSE(isInOrOn(wide, {0.5, -0.5}));
  EXPECT_TRUE(isOn(wide, {0, 0}));
  EXPECT_TRUE(isIn(Shape::sector({0, 0}, 1, 1, 1 + 2 * M_PI), {0.5, -0.5}));
  EXPECT_TRUE(isIn(Shape::sector({0, 0}, 1, 3, 1), {-0.5, 0}));  // over the x axis
}

TEST(HullZone, IgnoresPointsInside) {
  const Shape hull = Shape::hull({{1, 1}, {0, 0}, {4, 0}, {2, 0}, {0, 4}, {0, 4}});
  EXPECT_TRUE(isOn(hull, {2, 2}));
  EXPECT_TRUE(isIn(hull, {1, 1}));
  EXPECT_FALSE(isInOrOn(hull, up({2, 2})));
}

TEST(GrowZone, RoundsCorners) {
  const Shape grown = Shape::grow(rectangle({0, 0}, {4, 4}), 5);
  EXPECT_TRUE(isOn(grown, {7, 8}));
  EXPECT_FALSE(isInOrOn(grown, {8, 8}));
  EXPECT_TRUE(isOn(grown, {2, 9}));
  EXPECT_TRUE(isIn(grown, {4, 4}));
  EXPECT_TRUE(isIn(grown, {4, 2}));  // the side of the inner shape is a seam
  EXPECT_FALSE(enters(grown, {-9, 9}, {9, 9}));
}

TEST(GrowZone, MakesACapsuleOfTwoPointsAndADiscOfOne) {
  const Shape capsule = Shape::grow(Shape::hull({{0, 0}, {4, 0}}), 1);
  EXPECT_TRUE(isIn(capsule, {2, 0}));
  EXPECT_TRUE(isIn(capsule, {4, 0.5}));
  EXPECT_TRUE(isOn(capsule, {2, 1}));
  EXPECT_TRUE(isOn(capsule, {5, 0}));
  EXPECT_TRUE(isOn(Shape::grow(Shape::hull({{0, 0}}), 5), {3, 4}));
}

TEST(GrowZone, AddsUp) {
  const Shape twice = Shape::grow(Shape::grow(Shape::disc({0, 0}, 2), 1), 2);
  EXPECT_TRUE(isOn(twice, {3, 4}));
}

TEST(UnionZone, HasNoBoundaryAlongAnInnerSeam) {
  const Shape both = rectangle({0, 0}, {1, 1}) | rectangle({1, 0}, {2, 1});
  EXPECT_TRUE(isIn(both, {1, 0.5}));
  EXPECT_TRUE(isOn(both, {1, 0}));
  EXPECT_TRUE(enters(both, {1, 0.2}, {1, 0.8}));
  EXPECT_TRUE(enters(both, {1, -1}, {1, 2}));
  EXPECT_FALSE(enters(both, {1, -1}, {1, 0}));
  EXPECT_FALSE(enters(both, {-1, 1}, {3, 1}));
}

TEST(UnionZone, IsOpenWherePartsTouchInACorner) {
  const Shape both = rectangle({0, 0}, {1, 1}) | rectangle({1, 1}, {2, 2});
  EXPECT_TRUE(isOn(both, {1, 1}));
  EXPECT_FALSE(enters(both, {0, 2}, {2, 0}));
  EXPECT_TRUE(touches(both, {0, 2}, {2, 0}));
}

TEST(UnionZone, ClosesAroundAPointThatAllPartsTouch) {
  const Shape around = rectangle({0, 0}, {1, 1}) | rectangle({1, 0}, {2, 1}) |
                       rectangle({0, 1}, {1, 2}) | rectangle({1, 1}, {2, 2});
  EXPECT_TRUE(isIn(around, {1, 1}));
  EXPECT_TRUE(isOn(around - Shape::disc({2, 2}, 1), {1, 2}));
}

TEST(UnionZone, SeesTheGapBetweenADiscAndItsTangent) {
  const Shape both = Shape::disc({0, 1}, 1) | rectangle({-2, -1}, {2, 0});
  EXPECT_TRUE(isOn(both, {0, 0}));  // outside remains in the cusps beside the point of contact
  EXPECT_FALSE(enters(both, {0, 0}, {0, 0}));
  const Shape overlapping = Shape::disc({0, 1}, 1) | rectangle({-2, -1}, up({2, 0}));
  EXPECT_TRUE(isIn(overlapping, {0, 0}));
}

TEST(UnionZone, ClosesBetweenCirclesOfUnequalBend) {
  // The small disc touches the large one from inside; taking it away leaves cusps.
  const Shape crescent = Shape::disc({0, 0}, 4) - Shape::disc({2, 0}, 2);
  EXPECT_TRUE(isOn(crescent, {4, 0}));
  EXPECT_TRUE(isOn(crescent, {0, 0}));
  EXPECT_TRUE(isIn(crescent | Shape::disc({2, 0}, 2), {0, 0}));
  EXPECT_TRUE(isOn(crescent | Shape::disc({2, 0}, 2), {4, 0}));
}

TEST(DifferenceZone, LeavesNoSlit) {
  const Shape plate = rectangle({0, 0}, {4, 4});
  const Shape cut = (plate - rectangle({1, 1}, {2, 3})) - rectangle({2, 1}, {3, 3});
  EXPECT_FALSE(isInOrOn(cut, {2, 2}));
  EXPECT_FALSE(touches(cut, {2, 1.5}, {2, 2.5}));
  EXPECT_TRUE(isOn(cut, {2, 1}));
}

TEST(DifferenceZone, IsClosed) {
  const Shape rest = rectangle({0, 0}, {4, 4}) - Shape::disc({0, 0}, 1);
  EXPECT_TRUE(isOn(rest, {1, 0}));
  EXPECT_FALSE(isInOrOn(rest, {0, 0}));
  EXPECT_FALSE(enters(rest, {0, 0}, {0.5, 0.5}));
}

TEST(IntersectionZone, HoldsNothingWherePartsOnlyTouch) {
  const Shape touching =
      (rectangle({0, 0}, {1, 1}) & rectangle({1, 0}, {2, 1})) | rectangle({5, 5}, {6, 6});
  EXPECT_FALSE(isInOrOn(touching, {1, 0.5}));
  EXPECT_FALSE(enters(touching, {0, 0.5}, {2, 0.5}));
  EXPECT_FALSE(touches(touching, {1, 0.5}, {1, 2}));
}

TEST(ArcZone, BulgesOutAndIn) {
  // A square whose right side bulges out and whose left side bulges in.
  const Shape shape = Shape::poly({{{0, -3}, {}},
                                   {{8, -3}, {}},
                                   {{8, 3}, Point2{9, 0}},
                                   {{0, 3}, {}},
                                   {{0, -3}, Point2{1, 0}}});
  EXPECT_TRUE(isOn(shape, {9, 0}));
  EXPECT_TRUE(isOn(shape, {1, 0}));
  EXPECT_TRUE(isIn(shape, {8, 0}));
  EXPECT_FALSE(isInOrOn(shape, {0, 0}));
  EXPECT_TRUE(isOn(shape, {0, 3}));
  EXPECT_TRUE(enters(shape, {8, -2}, {8, 2}));   // along the chord of the outer arc
  EXPECT_FALSE(enters(shape, {0, -2}, {0, 2}));  // along the chord of the inner arc
  EXPECT_FALSE(enters(shape, {9, -5}, {9, 5}));  // tangent
  EXPECT_TRUE(enters(shape, {-1, 0}, {2, 0}));
}

TEST(ArcZone, OfTwoArcsIsADisc) {
  const Shape disc = Shape::poly({{{-5, 0}, Point2{3, 4}}, {{5, 0}, Point2{-3, -4}}});
  EXPECT_TRUE(isIn(disc, {0, 0}));
  EXPECT_TRUE(isIn(disc, {4.9, 0}));
  EXPECT_TRUE(isOn(disc, {-3, 4}));
  EXPECT_TRUE(isOn(disc, {5, 0}));
  EXPECT_FALSE(isInOrOn(disc, {5, 1}));
  EXPECT_TRUE(enters(disc, {-5, 0}, {5, 0}));
  EXPECT_FALSE(enters(disc, {-9, 5}, {9, 5}));
}

TEST(ArcZone, MayBeAFadedAwayArc) {
  const Shape shape =
      Shape::poly({{{0, 0}, {}}, {{1, 0}, {}}, {{1, 1}, {}}, {{1, 1}, Point2{1, 1}}, {{0, 1}, {}}});
  EXPECT_TRUE(isIn(shape, {0.5, 0.5}));
}

TEST(ListZone, IsTheEnginesConvexPolygon) {
  const MadeZone made = makeZone(Shape::convex({{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_NE(dynamic_cast<const ConvexPolygonZone*>(made.zone.get()), nullptr);
}

TEST(Zone, SurvivesEdgesFarAndPointlike) {
  const Shape shape = Shape::disc({0, 0}, 1) - Shape::disc({0.5, 0}, 0.25);
  EXPECT_FALSE(enters(shape, {1e200, 1e200}, {1e200, -1e200}));
  EXPECT_TRUE(enters(shape, {-1e100, 0}, {1e100, 0}));
  EXPECT_TRUE(enters(shape, {0, 0}, {0, 1e-300}));
  EXPECT_TRUE(enters(shape, {0, 0}, {0, 0}));
  EXPECT_FALSE(enters(shape, {0.5, 0}, {0.5, 0}));
}

// --- refusals

struct Case {
  Shape shape;
  Refusal refusal;
  const char* reason;
};

TEST(MakeZone, SaysWhyThereIsNoZone) {
  const Shape line = Shape::left({0, 0}, {1, 0});
  const Case cases[] = {
      {Shape::convex({{0, 0}, {2, 0}, {1, 0.5}, {1, 2}}), Refusal::Convexity,
       "the corners do not run counter-clockwise around a convex region"},
      {Shape::disc({0, 0}, -1), Refusal::Shape, "a radius is negative"},
      {Shape::sector({0, 0}, -1, 0, 1), Refusal::Shape, "a radius is negative"},
      {Shape::disc({kNan, 0}, 1), Refusal::NoValue, "a number is not finite or too large"},
      {Shape::disc({0, 1e308}, 1), Refusal::NoValue, "a number is not finite or too large"},
      {Shape::grow(Shape::left({0, 0}, {1e-320, 0}), 1), Refusal::NoValue,
       "a number is not finite or too large"},
      {Shape::left({0, 0}, {0, 0}), Refusal::NoValue, "a half plane has no direction"},
      {Shape::grow(Shape::disc({0, 0}, 1), -0.5), Refusal::Shape,
       "a distance to grow by is negative"},
      {Shape::grow(Shape::grow(Shape::disc({0, 0}, 1), -0.5), 1), Refusal::Shape,
       "a distance to grow by is negative"},
      {line, Refusal::Shape, "the zone has no bounds"},
      {Shape::hull({{0, 0}, {1, 1}}), Refusal::Shape, "the zone has no area"},
      {Shape::disc({0, 0}, 0), Refusal::Shape, "the zone has no area"},
      {Shape::poly({{{0, 0}, {}}, {{0, 1}, {}}, {{1, 0}, {}}}), Refusal::Shape,
       "the path does not run counter-clockwise around an area"},
      {Shape::poly({{{0, 0}, {}}, {{1, 1}, {}}, {{1, 0}, {}}, {{0, 1}, {}}}), Refusal::Shape,
       "the path crosses or touches itself"},
      {Shape::poly({{{0, 0}, {}}, {{2, 0}, {}}, {{1, 1}, Point2{1, -1}}}), Refusal::Shape,
       "the path crosses or touches itself"},
      {Shape::poly({{{0, 0}, {}}, {{1, 0}, Point2{2, 0}}, {{0, 1}, {}}}), Refusal::Shape,
       "an arc's three points lie on a line in the wrong order"},
      {Shape::poly({}), Refusal::Shape, "the path crosses or touches itself"},
      {Shape::disc({0, 0}, 1) | Shape::disc({0, 0}, -1), Refusal::Shape, "a radius is negative"},
  };
  for (const Case& one : cases) {
    const MadeZone made = makeZone(one.shape);
    EXPECT_EQ(made.zone, nullptr);
    EXPECT_EQ(made.refusal, one.refusal) << one.reason;
    EXPECT_STREQ(made.reason, one.reason);
  }
}

TEST(MakeZone, BoundsWhatHalfPlanesCloseOff) {
  const Shape triangle =
      Shape::left({0, 0}, {1, 0}) & Shape::left({1, 0}, {-1, 1}) & Shape::left({0, 1}, {0, -1});
  const MadeZone made = makeZone(triangle);
  ASSERT_TRUE(made.zone) << made.reason;
  const Box2 box = made.zone->boundingBox();
  EXPECT_NEAR(box.high.x, 1, 1e-6);
  EXPECT_NEAR(box.high.y, 1, 1e-6);
  EXPECT_TRUE(made.zone->contains({0.5, 0.5}, ZoneBoundary::Counts));
  EXPECT_FALSE(made.zone->contains({0.5, 0.5}, ZoneBoundary::Ignored));
}

TEST(MakeZone, LetsPartsFadeToNothing) {
  const Shape body = rectangle({0, 0}, {1, 1});
  EXPECT_TRUE(isIn(body | Shape::disc({1, 1}, 0), {0.5, 0.5}));
  EXPECT_TRUE(isIn(body - Shape::sector({0.5, 0.5}, 1, 1, 1), {0.5, 0.5}));
}

}  // namespace
}  // namespace af2::dsl
