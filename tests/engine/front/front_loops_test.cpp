#include "engine/front/front_loops.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/fronts.h"

namespace af2 {
namespace {

using namespace af2::testing;

std::vector<Point2> polygon(std::size_t corners, double radius = 10) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(corners);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

/// a -> new d -> other -> b, where `other` is a vertex of the front: a quadrilateral.
std::vector<WalkVertex> quadTo(const Front& front, PlaceId other, std::size_t newId) {
  return {newVertex(newId, {0, 0}), existingVertex(front, other)};
}

bool allows(const Front& front, PlaceId base, PlaceId other) {
  const std::array joined{PlaceId(), other};
  return front.loops().allow(front, base, joined);
}

TEST(FrontLoops, HaveTheirSizesAndColoursInTurn) {
  Front front;
  addPolygon(front, polygon(8));
  addPolygon(front, polygon(5, 2), 8);
  EXPECT_FALSE(front.loops().areNumbered());
  front.keepLoops();
  EXPECT_EQ(front.loops().sizeOfLoop(placeOf(front, 3)), 8);
  EXPECT_EQ(front.loopSize(placeOf(front, 9)), 5);
  EXPECT_TRUE(front.loops().isInOddLoop(placeOf(front, 9)));
  EXPECT_TRUE(front.loops().areInOneLoop(placeOf(front, 0), placeOf(front, 7)));
  EXPECT_FALSE(front.loops().areInOneLoop(placeOf(front, 0), placeOf(front, 8)));
  EXPECT_NE(front.loops().colour(placeOf(front, 2)), front.loops().colour(placeOf(front, 3)));
  EXPECT_TRUE(front.loops().areSound(front));
}

TEST(FrontLoops, OfAPieceAreJoinedByColours) {
  Front front;
  const auto chain = [&](std::size_t first, double y) {
    std::vector<BoundaryCorner> corners;
    for (std::size_t i = 0; i < 4; ++i)
      corners.push_back({VertexId(first + i), {{double(i), y, 0}, {0, 0, 1}, double(i), y}});
    return front.addOpenChain(corners, std::vector<double>(4, 1.0));
  };
  const PlaceId lower = chain(0, 0), upper = chain(4, 3);
  front.keepLoops();
  EXPECT_FALSE(front.loops().areInOneLoop(lower, upper));
  front.joinChains(std::array{std::pair(lower, false), std::pair(upper, true)});
  EXPECT_TRUE(front.loops().areInOneLoop(lower, upper));
  EXPECT_FALSE(front.loops().isInOddLoop(lower));
  EXPECT_TRUE(allows(front, front.next(lower), upper) !=
              allows(front, front.next(lower), front.next(upper)));
}

TEST(FrontLoops, AllowOnlyStepsThatLeaveEvenLoops) {
  Front front;
  addPolygon(front, polygon(12));
  front.keepLoops();
  // 0 -> new -> v -> 1 leaves the loops 0 new v ... and 1 ... v.
  for (std::size_t v = 3; v < 11; ++v) {
    const bool isEven = (v - 1) % 2 != 0;  // v - 1 edges from 1 to v, and the one back
    EXPECT_EQ(allows(front, placeOf(front, 0), placeOf(front, v)), isEven) << v;
  }
}

TEST(FrontLoops, RefuseWalksThatAddAnOddNumberOfEdges) {
  Front front;
  addPolygon(front, polygon(6));
  front.keepLoops();
  const std::array apex{PlaceId()};
  EXPECT_FALSE(front.loops().allow(front, placeOf(front, 0), apex));
}

TEST(FrontLoops, MayAlwaysBeJoinedAndThenHaveFittingColours) {
  for (std::size_t v : {12u, 13u}) {
    Front front;
    addPolygon(front, polygon(12));
    addPolygon(front, polygon(6, 2), 12);
    front.keepLoops();
    const PlaceId other = placeOf(front, v);
    EXPECT_TRUE(allows(front, placeOf(front, 0), other));
    Front::Change change;
    front.replace(placeOf(front, 0), quadTo(front, other, 18), change);
    EXPECT_EQ(front.loops().sizeOfLoop(placeOf(front, 0)), 20);
    EXPECT_TRUE(front.loops().areSound(front));
  }
}

TEST(FrontLoops, RefuseToJoinAnotherLoopWithBothEndsOfAnEvenWay) {
  Front front;
  addPolygon(front, polygon(12));
  addPolygon(front, polygon(6, 2), 12);
  front.keepLoops();
  const PlaceId base = placeOf(front, 0);
  const std::array neighbours{placeOf(front, 12), placeOf(front, 13)};
  EXPECT_TRUE(front.loops().allow(front, base, neighbours));
  const std::array apart{placeOf(front, 12), placeOf(front, 14)};
  EXPECT_FALSE(front.loops().allow(front, base, apart));
}

TEST(FrontLoops, ThatAreOddBecomeOneEvenLoop) {
  Front front;
  addPolygon(front, polygon(11));
  addPolygon(front, polygon(5, 2), 11);
  front.keepLoops();
  EXPECT_TRUE(allows(front, placeOf(front, 0), placeOf(front, 4)));
  Front::Change change;
  front.replace(placeOf(front, 0), quadTo(front, placeOf(front, 12), 16), change);
  EXPECT_FALSE(front.loops().isInOddLoop(placeOf(front, 0)));
  EXPECT_EQ(front.loops().sizeOfLoop(placeOf(front, 0)), 18);
  EXPECT_TRUE(front.loops().areSound(front));
}

TEST(FrontLoops, ThatAreOddLeaveOneOddPart) {
  for (std::size_t v : {4u, 5u, 6u}) {
    Front front;
    addPolygon(front, polygon(11));
    front.keepLoops();
    Front::Change change;
    const PlaceId base = placeOf(front, 0), other = placeOf(front, v);
    ASSERT_TRUE(allows(front, base, other));
    front.replace(base, quadTo(front, other, 11), change);
    EXPECT_NE(front.loops().isInOddLoop(base), front.loops().isInOddLoop(placeOf(front, 1)));
    EXPECT_TRUE(front.loops().areSound(front));
  }
}

TEST(FrontLoops, AreTwoEdgesShorterAfterAWeld) {
  Front front;
  addPolygon(front, polygon(8));
  front.keepLoops();
  Front::Change change;
  front.weld(placeOf(front, 2), placeOf(front, 4), VertexId(2), front[placeOf(front, 2)].point,
             change);
  front.release(change);
  EXPECT_EQ(front.loops().sizeOfLoop(placeOf(front, 0)), 6);
  EXPECT_EQ(loopsOf(front), (std::vector<VertexLoop>{{0, 1, 2, 5, 6, 7}}));
  EXPECT_TRUE(front.loops().areSound(front));
}

// Each step is one that `allow` accepts; after it, sizes and colours are those of the links.
TEST(FrontLoops, StaySoundInRandomFronts) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Front front;
    std::size_t vertices = 0;
    for (const std::size_t corners : {20u, 8u, 7u, 5u, 6u}) {
      addPolygon(front, polygon(corners), vertices);
      vertices += corners;
    }
    front.keepLoops();
    Front::Change change;
    for (int step = 0; step < 60; ++step) {
      std::vector<PlaceId> used;
      for (std::size_t i = 0; i < front.capacity(); ++i)
        if (front.hasEdge(PlaceId(i))) used.push_back(PlaceId(i));
      if (used.empty()) break;
      const PlaceId base = used[random() % used.size()], other = used[random() % used.size()];
      if (other == base || other == front.next(base) || !allows(front, base, other)) continue;
      front.replace(base, quadTo(front, other, vertices++), change);
      front.release(change);
      ASSERT_TRUE(front.loops().areSound(front)) << step;
    }
  }
}

}  // namespace
}  // namespace af2
