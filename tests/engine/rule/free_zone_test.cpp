// Numbers marked "reference" are those of MeshKit's tests of its free zone
// (test/algs/AdvFront/freeZone.cpp). Its answers allow a relative slack of 1e-14; AF2 decides
// exactly on the coordinates as they are stored. Where the two differ the exact answer is tested
// and the difference named.
#include "engine/rule/free_zone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "engine/base/error.h"
#include "engine/base/predicates.h"

namespace af2 {
namespace {

using Points = std::vector<Point2>;
constexpr auto kCounts = ZoneBoundary::Counts;
constexpr auto kIgnored = ZoneBoundary::Ignored;

const Points kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Points kClockwiseSquare{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
const Points kTinyPentagon{{0, 0},
                           {1e-14, 0},
                           {1.39735982487e-14, 1.1091842589e-14},
                           {5e-15, 1.74370722192e-14},
                           {-3.9735982487e-15, 1.1091842589e-14}};
const Points kHugeDiamond{{0, 0}, {5e39, 5e39}, {0, 1e40}, {-5e39, 5e39}};
const Points kDent{{0, 0}, {1, 0}, {.9999, .5}, {.9999, 1}, {0, 1}};
const Points kDoubleLoop{{0, 0}, {1, 0}, {.5, 1}, {-.125, .25}, {.375, -.25}, {.875, .75}, {0, 1}};
const Points kWide{{0, 0}, {1, 0}, {1.4, .7}, {.5, .8660254037844386}, {-.4, .7}};

bool contains(const Points& corners, Point2 point, ZoneBoundary boundary) {
  return ConvexPolygonZone(corners).contains(point, boundary);
}
bool meets(const Points& corners, Point2 from, Point2 to, ZoneBoundary boundary) {
  const ConvexPolygonZone zone(corners);
  const bool result = zone.meets(from, to, boundary);
  EXPECT_EQ(zone.meets(to, from, boundary), result) << "the direction of a segment matters";
  return result;
}

Points scaled(double s, const Points& points) {
  Points result;
  for (Point2 p : points) result.push_back(s * p);
  return result;
}

// ---- convexity ---------------------------------------------------------------------------------

TEST(FreeZone, IsConvexIfItsCornersRunOnceAroundCounterClockwise) {
  EXPECT_TRUE(ConvexPolygonZone::isConvex(kSquare));  // reference, line 155
  EXPECT_TRUE(ConvexPolygonZone::isConvex(kTinyPentagon));
  EXPECT_TRUE(ConvexPolygonZone::isConvex(kHugeDiamond));
  EXPECT_TRUE(ConvexPolygonZone::isConvex(kWide));
}

TEST(FreeZone, IsNotConvexClockwise) {  // reference, line 169
  EXPECT_FALSE(ConvexPolygonZone::isConvex(kClockwiseSquare));
}

TEST(FreeZone, IsNotConvexWithADent) { EXPECT_FALSE(ConvexPolygonZone::isConvex(kDent)); }

TEST(FreeZone, IsNotConvexWhereItsCornersRunAroundTwice) {  // reference, line 215
  EXPECT_FALSE(ConvexPolygonZone::isConvex(kDoubleLoop));
  const Points pentagram{{0, 1}, {-.59, -.81}, {.95, .31}, {-.95, .31}, {.59, -.81}};
  EXPECT_FALSE(ConvexPolygonZone::isConvex(pentagram));
  Points twice = kSquare;
  twice.insert(twice.end(), kSquare.begin(), kSquare.end());
  EXPECT_FALSE(ConvexPolygonZone::isConvex(twice));
}

TEST(FreeZone, IsNotConvexWithoutArea) {
  EXPECT_FALSE(ConvexPolygonZone::isConvex(Points{}));
  EXPECT_FALSE(ConvexPolygonZone::isConvex(Points{{0, 0}, {1, 0}}));
  EXPECT_FALSE(ConvexPolygonZone::isConvex(Points{{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_FALSE(ConvexPolygonZone::isConvex(Points{{0, 0}, {1, 0}, {2, 0}, {1, 0}}));
  EXPECT_FALSE(ConvexPolygonZone::isConvex(Points{{1, 1}, {1, 1}, {1, 1}, {1, 1}}));
}

TEST(FreeZone, IsNotConvexWithASpike) {
  EXPECT_FALSE(ConvexPolygonZone::isConvex(Points{{0, 0}, {2, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

TEST(FreeZone, MayHaveStraightAndCoincidingCorners) {
  EXPECT_TRUE(ConvexPolygonZone::isConvex(Points{{0, 0}, {.5, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_TRUE(ConvexPolygonZone::isConvex(Points{{0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}, {0, 0}}));
  EXPECT_TRUE(ConvexPolygonZone::isConvex(Points{{0, 0}, {1, 0}, {.5, 1}, {.5, 1}, {.5, 1}}));
}

TEST(FreeZone, TakesACornerARoundingErrorInsideAChordForStraight) {
  EXPECT_TRUE(ConvexPolygonZone::isConvex(Points{{0, 0}, {.5, 1e-12}, {1, 0}, {.5, 1}}));
  EXPECT_FALSE(ConvexPolygonZone::isConvex(Points{{0, 0}, {.5, 1e-8}, {1, 0}, {.5, 1}}));
}

TEST(FreeZone, JudgesConvexityByTheExtentOfASmallZone) {
  const Points fineDent{{0, 0}, {1, 0}, {.5, .5}, {0, 1}, {.1, .5}};
  for (double s : {1.0, 1e-6, 1e-9, 1e-14, 1e-40}) {
    EXPECT_FALSE(ConvexPolygonZone::isConvex(scaled(s, kDent))) << s;
    EXPECT_FALSE(ConvexPolygonZone::isConvex(scaled(s, fineDent))) << s;
    EXPECT_FALSE(ConvexPolygonZone::isConvex(scaled(s, kClockwiseSquare))) << s;
    EXPECT_FALSE(ConvexPolygonZone::isConvex(scaled(s, kDoubleLoop))) << s;
    EXPECT_TRUE(ConvexPolygonZone::isConvex(scaled(s, kSquare))) << s;
  }
}

TEST(FreeZone, TakesCornersForOneThatHaveChangedPlacesByRounding) {
  const double eps = 1e-15;
  EXPECT_TRUE(ConvexPolygonZone::isConvex(Points{{0, 0}, {1, 0}, {1, 1}, {1, 1 - eps}, {0, 1}}));
  EXPECT_TRUE(ConvexPolygonZone::isConvex(Points{{0, 0}, {1, 0}, {1 - eps, 0}, {1, 1}, {0, 1}}));
}

TEST(FreeZone, IsConvexWhicheverCornerComesFirst) {
  for (const Points& corners : {kSquare, kTinyPentagon, kHugeDiamond, kDent, kDoubleLoop, kWide,
                                Points{{0, 0}, {.5, 1e-12}, {1, 0}, {.5, 1}}}) {
    Points turned = corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      EXPECT_EQ(ConvexPolygonZone::isConvex(turned), ConvexPolygonZone::isConvex(corners));
    }
  }
}

TEST(FreeZone, CannotBeMadeOfCornersThatAreNotConvex) {
  EXPECT_THROW(ConvexPolygonZone{kDent}, InputError);
  EXPECT_THROW(ConvexPolygonZone{kClockwiseSquare}, InputError);
}

TEST(FreeZone, IsNotConvexWithCornersThatAreNotNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (double bad : {nan, inf, -inf}) {
    EXPECT_FALSE(ConvexPolygonZone::isConvex(Points{{0, 0}, {1, 0}, {bad, 1}})) << bad;
    EXPECT_FALSE(ConvexPolygonZone::isConvex(Points{{0, 0}, {1, 0}, {1, bad}, {0, 1}})) << bad;
  }
}

TEST(FreeZone, HasNoReflexCornerLeftAfterNormalizing) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> noise(-5e-10, 5e-10);
  for (int n = 0; n < 2000; ++n) {
    Points corners;
    for (int side = 0; side < 4; ++side) {
      const Point2 p = kSquare[static_cast<std::size_t>(side)];
      const Point2 q = kSquare[static_cast<std::size_t>((side + 1) % 4)];
      for (int k = 0; k < 3; ++k)
        corners.push_back(p + (k / 3.0) * (q - p) +
                          (k == 0 ? Point2{} : Point2{noise(random), noise(random)}));
    }
    std::rotate(corners.begin(), corners.begin() + n % 12, corners.end());
    const int count = convex_polygon::normalize(corners.data(), static_cast<int>(corners.size()));
    if (count == 0) continue;  // noise may add up to more than the tolerance
    for (int i = 0; i < count; ++i)
      ASSERT_NE(orientation(corners[static_cast<std::size_t>(i)],
                            corners[static_cast<std::size_t>((i + 1) % count)],
                            corners[static_cast<std::size_t>((i + 2) % count)]),
                Turn::Right)
          << "round " << n << ", corner " << (i + 1) % count << " of " << count;
  }
}

// ---- points ------------------------------------------------------------------------------------

TEST(FreeZone, ContainsItsCornersIfItsBoundaryCounts) {
  EXPECT_TRUE(contains(kSquare, {1, 0}, kCounts));  // reference, line 250
  for (const Points& corners : {kSquare, kTinyPentagon, kHugeDiamond, kWide})
    for (Point2 p : corners) EXPECT_TRUE(contains(corners, p, kCounts));
}

TEST(FreeZone, DoesNotContainItsCornersIfItsBoundaryIsIgnored) {
  EXPECT_FALSE(contains(kTinyPentagon, kTinyPentagon[2], kIgnored));  // reference, line 307
  for (const Points& corners : {kSquare, kTinyPentagon, kHugeDiamond, kWide})
    for (Point2 p : corners) EXPECT_FALSE(contains(corners, p, kIgnored));
}

TEST(FreeZone, ContainsWhatLiesInside) {
  EXPECT_TRUE(contains(kTinyPentagon, {6.25e-15, 1.25e-14}, kIgnored));  // reference, line 288
  EXPECT_TRUE(contains(kSquare, {.5, .5}, kIgnored));
  EXPECT_FALSE(contains(kSquare, {1.5, .5}, kCounts));
}

TEST(FreeZone, DoesNotContainWhatLiesBeyondAnEdgeByTheLastDigits) {
  // Reference, line 269, says "inside" to a point that lies outside by 1e-14 of its coordinates.
  EXPECT_FALSE(contains(kHugeDiamond, {2.5e39, 2.49999999999999e39}, kIgnored));
  EXPECT_FALSE(contains(kHugeDiamond, {2.5e39, 2.49999999999999e39}, kCounts));
  EXPECT_TRUE(contains(kHugeDiamond, {2.49999999999999e39, 2.5e39}, kIgnored));
  EXPECT_TRUE(contains(kHugeDiamond, {2.5e39, 2.5e39}, kCounts)) << "on the edge";
  EXPECT_FALSE(contains(kHugeDiamond, {2.5e39, 2.5e39}, kIgnored));
}

TEST(FreeZone, TellsInsideFromOutsideByTheLastBit) {
  const double above = std::nextafter(1.0, 2.0), below = std::nextafter(1.0, 0.0);
  EXPECT_TRUE(contains(kSquare, {below, .5}, kIgnored));
  EXPECT_TRUE(contains(kSquare, {1, .5}, kCounts));
  EXPECT_FALSE(contains(kSquare, {1, .5}, kIgnored));
  EXPECT_FALSE(contains(kSquare, {above, .5}, kCounts));
}

TEST(FreeZone, ContainsAndMeetsTheSameAtEveryScale) {
  std::mt19937 random(12);
  std::uniform_int_distribution<int> grid(-4, 8);
  for (int n = 0; n < 1000; ++n) {
    // Powers of two scale without rounding.
    const Point2 p{grid(random) / 4.0, grid(random) / 4.0},
        q{grid(random) / 4.0, grid(random) / 4.0};
    for (double s : {std::ldexp(1.0, -46), std::ldexp(1.0, 20), std::ldexp(1.0, 132)}) {
      const Points zone = scaled(s, kSquare);
      for (ZoneBoundary b : {kCounts, kIgnored}) {
        ASSERT_EQ(contains(zone, s * p, b), contains(kSquare, p, b));
        ASSERT_EQ(meets(zone, s * p, s * q, b), meets(kSquare, p, q, b));
      }
    }
  }
}

// ---- segments ----------------------------------------------------------------------------------

TEST(FreeZone, IsNotMetByASegmentThatPassesACorner) {  // reference, line 328
  EXPECT_FALSE(meets(kSquare, {1.2500001, .75}, {.75, 1.25}, kIgnored));
  EXPECT_TRUE(meets(kSquare, {1.2499999, .75}, {.75, 1.2499999}, kIgnored));
}

TEST(FreeZone, IsTouchedAtACornerIfItsBoundaryCounts) {  // reference, line 349
  EXPECT_TRUE(meets(kSquare, {1, 1}, {1.5, 1.5}, kCounts));
  EXPECT_FALSE(meets(kSquare, {1, 1}, {1.5, 1.5}, kIgnored));
}

TEST(FreeZone, IsNotMetByASegmentAwayFromACorner) {
  // Reference, lines 398, 418 and 441.
  EXPECT_FALSE(meets(kTinyPentagon, {1e-14, 1.75e-14}, {5.0002e-15, 1.7437e-14}, kIgnored));
  EXPECT_FALSE(meets(kTinyPentagon, {1.5e-14, 9.5e-15}, {1.3e-14, 1.3e-14}, kIgnored));
  EXPECT_FALSE(meets(kTinyPentagon, {5e-15, 1.74370722192e-14}, {7e-15, 3e-14}, kIgnored));
}

TEST(FreeZone, IsMetByASegmentThatRunsInAtACorner) {  // reference, line 490
  EXPECT_TRUE(meets(kHugeDiamond, {-1e39, 6.1e39}, {0, 9.9999999999999e39}, kIgnored));
}

TEST(FreeZone, DecidesSegmentsExactlyWhereTheReferenceAllowsASlack) {
  // Reference, line 370, says "meets" to a segment that ends 1e-18 outside of a zone of 1e-14.
  EXPECT_FALSE(
      meets(kTinyPentagon, {1e-14, 1.75e-14}, {5.00010213437881e-15, 1.7437e-14}, kIgnored));
  // Reference, line 466, says "apart" to a segment that begins inside, 1e-14 of its coordinates
  // below the corner (0, 1e40).
  EXPECT_TRUE(meets(kHugeDiamond, {0, 9.9999999999999e39}, {5e39, 5e39}, kIgnored));
}

TEST(FreeZone, IsNotMetByItsOwnEdgesIfItsBoundaryIsIgnored) {
  for (const Points& corners : {kSquare, kTinyPentagon, kHugeDiamond, kWide}) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point2 p = corners[i], q = corners[(i + 1) % corners.size()];
      EXPECT_FALSE(meets(corners, p, q, kIgnored));
      EXPECT_TRUE(meets(corners, p, q, kCounts));
    }
  }
}

TEST(FreeZone, IsMetByItsDiagonalsAndByWhatLiesInside) {
  EXPECT_TRUE(meets(kSquare, {0, 0}, {1, 1}, kIgnored));
  EXPECT_TRUE(meets(kSquare, {.25, .25}, {.5, .5}, kIgnored));
  EXPECT_TRUE(meets(kSquare, {-1, .5}, {2, .5}, kIgnored));
}

TEST(FreeZone, IsNotMetByASegmentInLineWithAnEdge) {
  EXPECT_FALSE(meets(kSquare, {-1, 0}, {2, 0}, kIgnored)) << "along the edge";
  EXPECT_TRUE(meets(kSquare, {-1, 0}, {2, 0}, kCounts));
  EXPECT_FALSE(meets(kSquare, {2, 0}, {3, 0}, kCounts)) << "ends before the polygon begins";
  EXPECT_TRUE(meets(kSquare, {1, 0}, {3, 0}, kCounts)) << "touches the corner";
}

TEST(FreeZone, TreatsASegmentOfLengthZeroAsAPoint) {
  EXPECT_TRUE(meets(kSquare, {.5, .5}, {.5, .5}, kIgnored));
  EXPECT_FALSE(meets(kSquare, {1, .5}, {1, .5}, kIgnored));
  EXPECT_TRUE(meets(kSquare, {1, .5}, {1, .5}, kCounts));
  EXPECT_FALSE(meets(kSquare, {2, .5}, {2, .5}, kCounts));
}

/// Whether a segment meets a polygon, from crossings of its edges and ends inside alone.
bool meetsByHand(const Points& zone, Point2 p, Point2 q) {
  if (contains(zone, p, kCounts) || contains(zone, q, kCounts)) return true;
  for (std::size_t i = 0; i < zone.size(); ++i)
    if (segmentsMeet(p, q, zone[i], zone[(i + 1) % zone.size()])) return true;
  return false;
}

TEST(FreeZone, MeetsWhatItsEdgesCrossOrWhatEndsInIt) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> grid(-3, 7);
  for (const Points& zone : {kSquare, Points{{0, 0}, {1, 0}, {1.5, .75}, {.5, 1.25}, {-.5, .75}}}) {
    for (int n = 0; n < 5000; ++n) {
      const Point2 p{grid(random) / 4.0, grid(random) / 4.0};
      const Point2 q{grid(random) / 4.0, grid(random) / 4.0};
      ASSERT_EQ(meets(zone, p, q, kCounts), meetsByHand(zone, p, q))
          << p.x << " " << p.y << " - " << q.x << " " << q.y;
      // The open polygon is met iff some inner point of it lies on the segment: shrink it a little.
      Points inner = zone;
      Point2 middle;
      for (Point2 c : zone) middle = middle + (1.0 / static_cast<double>(zone.size())) * c;
      for (Point2& c : inner) c = middle + (1 - 1e-9) * (c - middle);
      ASSERT_EQ(meets(zone, p, q, kIgnored), meets(inner, p, q, kCounts))
          << p.x << " " << p.y << " - " << q.x << " " << q.y;
    }
  }
}

TEST(FreeZone, HasABoxThatHoldsItsCorners) {
  const Box2 box = ConvexPolygonZone(kWide).boundingBox();
  EXPECT_EQ(box.low, (Point2{-.4, 0}));
  EXPECT_EQ(box.high, (Point2{1.4, .8660254037844386}));
}

// ---- definitions -------------------------------------------------------------------------------

std::shared_ptr<const AF2PointTransform> fixed(double x, double y) {
  return std::make_shared<AffinePointTransform>(Point2{x, y},
                                                std::vector<AffinePointTransform::Term>{});
}

class NoValue final : public AF2PointTransform {
  std::optional<Point2> transformPoint(const AF2Binding&) const override { return std::nullopt; }
};

const AF2Surroundings kNothingAround;
const Points kBase{{0, 0}, {1, 0}};

AF2FreeZoneDef::Made make(const ConvexPolygonZoneDef& def, int level) {
  return def.makeFreeZone({kBase, level, &kNothingAround});
}

TEST(FreeZoneDef, FadesFromPreferredToLimitingCorners) {
  const ConvexPolygonZoneDef def({{fixed(0, 0)}, {fixed(1, 0)}, {fixed(0, 8), fixed(0, 4)}},
                                 {1, .5, .25});
  for (const auto& [level, height] : {std::pair(1, 8.0), {2, 6.0}, {3, 5.0}, {50, 5.0}}) {
    const auto made = make(def, level);
    ASSERT_TRUE(made.zone);
    EXPECT_EQ(made.refusal, Refusal::None);
    EXPECT_EQ(made.zone->boundingBox().high.y, height) << level;
  }
}

TEST(FreeZoneDef, KeepsCornersWithoutALimitToTheLastBit) {
  const double x = .1 + .2;
  const ConvexPolygonZoneDef def({{fixed(0, 0)}, {fixed(x, 0)}, {fixed(0, 1)}}, {1, 1.0 / 3});
  EXPECT_EQ(make(def, 2).zone->boundingBox().high.x, x);
}

TEST(FreeZoneDef, IsRefusedWhereItsCornersAreNotConvex) {
  const ConvexPolygonZoneDef def(
      {{fixed(0, 0)}, {fixed(1, 0)}, {fixed(.5, 1), fixed(.5, -1)}, {fixed(0, 1)}}, {1, 0});
  EXPECT_TRUE(make(def, 1).zone);
  const auto made = make(def, 2);
  EXPECT_FALSE(made.zone);
  EXPECT_EQ(made.refusal, Refusal::Convexity);
}

TEST(FreeZoneDef, IsRefusedWhereACornerHasNoValue) {
  const ConvexPolygonZoneDef def({{fixed(0, 0)}, {fixed(1, 0)}, {std::make_shared<NoValue>()}},
                                 {1});
  const auto made = make(def, 1);
  EXPECT_FALSE(made.zone);
  EXPECT_EQ(made.refusal, Refusal::NoValue);
}

TEST(FreeZoneDef, NeedsThreeCornersEachWithAPlaceAndAFade) {
  EXPECT_THROW(ConvexPolygonZoneDef({{fixed(0, 0)}, {fixed(1, 0)}}, {1}), InputError);
  EXPECT_THROW(ConvexPolygonZoneDef({{fixed(0, 0)}, {fixed(1, 0)}, {fixed(0, 1)}}, {}), InputError);
  EXPECT_THROW(ConvexPolygonZoneDef({{fixed(0, 0)}, {fixed(1, 0)}, {nullptr}}, {1}), InputError);
}

}  // namespace
}  // namespace af2
