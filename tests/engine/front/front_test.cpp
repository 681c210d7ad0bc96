#include "engine/front/front.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "tests/support/fronts.h"

namespace af2 {
namespace {

using namespace af2::testing;
using Loops = std::vector<VertexLoop>;

const std::vector<Point2> kHexagon{{0, 0}, {2, 0}, {3, 2}, {2, 4}, {0, 4}, {-1, 2}};

/// What holds for every front: links are mutual, counts are right.
void expectSound(const Front& front) {
  std::size_t edges = 0, isolated = 0;
  for (std::size_t i = 0; i < front.capacity(); ++i) {
    const PlaceId id(i);
    if (!front.isUsed(id)) continue;
    EXPECT_EQ(front.previous(front.next(id)), id);
    EXPECT_EQ(front.next(front.previous(id)), id);
    EXPECT_TRUE(front.isUsed(front.next(id)));
    edges += front.hasEdge(id);
    isolated += front.isIsolated(id);
  }
  EXPECT_EQ(front.edgeCount(), edges);
  EXPECT_EQ(front.isolatedCount(), isolated);
  EXPECT_EQ(front.isEmpty(), edges == 0);
}

void replace(Front& front, std::size_t base, const std::vector<WalkVertex>& walk,
             Front::Change& change) {
  front.replace(placeOf(front, base), walk, change);
  expectSound(front);
}

void replace(Front& front, std::size_t base, const std::vector<WalkVertex>& walk) {
  Front::Change change;
  replace(front, base, walk, change);
  front.release(change);
}

TEST(Front, HoldsTheLoopsThatItWasGiven) {
  Front front;
  addPolygon(front, kHexagon);
  addPolygon(front, {{1, 1}, {1, 2}, {2, 2}}, 6);
  expectSound(front);
  EXPECT_EQ(loopsOf(front), (Loops{{0, 1, 2, 3, 4, 5}, {6, 7, 8}}));
  EXPECT_EQ(front.edgeCount(), 9u);
  EXPECT_EQ(front.loopSize(placeOf(front, 4)), 6);
  EXPECT_EQ(front.loopSize(placeOf(front, 7)), 3);
  EXPECT_DOUBLE_EQ(front.edgeLength(placeOf(front, 0)), 2);
}

TEST(Front, HasAnEdgeLessInAnOpenChain) {
  Front front;
  std::vector<BoundaryCorner> corners{flatCorner(0, {0, 0}), flatCorner(1, {1, 0}),
                                      flatCorner(2, {2, 0})};
  const PlaceId first = front.addOpenChain(corners, std::vector<double>(3, 1.0));
  const PlaceId last(first.value + 2);
  EXPECT_EQ(front.edgeCount(), 2u);
  EXPECT_TRUE(front.hasEdge(first));
  EXPECT_FALSE(front.hasEdge(last));
  EXPECT_FALSE(front.hasEdgeBefore(first));
  EXPECT_TRUE(front.hasEdgeBefore(last));
}

TEST(Front, TakesANewVertexInTheMiddleOfAnEdge) {
  Front front;
  addPolygon(front, kHexagon);
  replace(front, 0, {newVertex(6, {1, 1})});
  EXPECT_EQ(loopsOf(front), (Loops{{0, 6, 1, 2, 3, 4, 5}}));
}

TEST(Front, SplitsALoopAtAVertexOfItsOwn) {
  Front front;
  addPolygon(front, kHexagon);
  replace(front, 0, {existingVertex(front, placeOf(front, 3))});
  EXPECT_EQ(loopsOf(front), (Loops{{0, 3, 4, 5}, {1, 2, 3}}));
}

TEST(Front, JoinsTwoLoopsAtAVertexOfTheOther) {
  Front front;
  addPolygon(front, kHexagon);
  addPolygon(front, {{1, 1}, {1, 2}, {2, 2}}, 6);
  replace(front, 0, {existingVertex(front, placeOf(front, 6))});
  EXPECT_EQ(loopsOf(front), (Loops{{0, 6, 7, 8, 6, 1, 2, 3, 4, 5}}));
}

TEST(Front, CancelsOppositeEdgesAtACornerThatIsFilled) {
  Front front;
  addPolygon(front, kHexagon);
  replace(front, 0, {existingVertex(front, placeOf(front, 2))});
  EXPECT_EQ(loopsOf(front), (Loops{{0, 2, 3, 4, 5}}));
  replace(front, 0, {existingVertex(front, placeOf(front, 5))});
  EXPECT_EQ(loopsOf(front), (Loops{{2, 3, 4, 5}}));
}

TEST(Front, IsEmptyWhenItsLastTriangleIsFilled) {
  Front front;
  addPolygon(front, {{0, 0}, {1, 0}, {0, 1}});
  Front::Change change;
  replace(front, 0, {existingVertex(front, placeOf(front, 2))}, change);
  EXPECT_TRUE(front.isEmpty());
  EXPECT_TRUE(change.added.empty());
  EXPECT_EQ(change.removed.size(), 4u);
}

TEST(Front, IsEmptyWhenItsLastQuadrilateralIsFilled) {
  Front front;
  addPolygon(front, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  replace(front, 0,
          {existingVertex(front, placeOf(front, 3)), existingVertex(front, placeOf(front, 2))});
  EXPECT_TRUE(front.isEmpty());
}

TEST(Front, TakesInAnIsolatedVertex) {
  Front front;
  addPolygon(front, kHexagon);
  front.addIsolated(flatCorner(6, {1, 1}), 1);
  expectSound(front);
  EXPECT_EQ(front.isolatedCount(), 1u);
  Front::Change change;
  replace(front, 0, {existingVertex(front, placeOf(front, 6))}, change);
  EXPECT_EQ(front.isolatedCount(), 0u);
  EXPECT_EQ(loopsOf(front), (Loops{{0, 6, 1, 2, 3, 4, 5}}));
  EXPECT_EQ(change.removed.size(), 1u);
}

TEST(Front, PinchesWhereElementsTouchInANewVertex) {
  Front front;
  addPolygon(front, kHexagon);
  // Two triangles a b e and c d e: the walk goes a -> e -> d -> c -> e -> b.
  replace(front, 0,
          {newVertex(6, {1, 2}), existingVertex(front, placeOf(front, 4)),
           existingVertex(front, placeOf(front, 3)), newVertex(6, {1, 2})});
  EXPECT_EQ(loopsOf(front), (Loops{{0, 6, 4, 5}, {1, 2, 3, 6}}));
}

TEST(Front, PinchLeavesTwoPlacesOfOneVertex) {
  Front front;
  addPolygon(front, kHexagon);
  replace(front, 0, {existingVertex(front, placeOf(front, 3))});
  const auto isAtThree = [&](std::size_t i) {
    return front.isUsed(PlaceId(i)) && front[PlaceId(i)].vertex == VertexId(3u);
  };
  int places = 0;
  for (std::size_t i = 0; i < front.capacity(); ++i) places += isAtThree(i);
  EXPECT_EQ(places, 2);
}

TEST(Front, GivesNewEdgesLevelOneAndAgesThatCountUp) {
  Front front;
  const PlaceId base = addPolygon(front, kHexagon);
  const PlaceId kept = front.next(base);
  front.raiseLevel(base);
  front.raiseLevel(base);
  front.raiseLevel(kept);
  const std::uint32_t oldest = front[front.previous(base)].age;
  Front::Change change;
  replace(front, 0, {newVertex(6, {.5, 1}), newVertex(7, {1.5, 1})}, change);
  ASSERT_EQ(change.added.size(), 3u);
  EXPECT_EQ(change.added[0], base) << "the base's place has a new edge";
  std::uint32_t age = oldest;
  for (PlaceId id : change.added) {
    EXPECT_EQ(front[id].level, 1);
    EXPECT_GT(front[id].age, age);
    age = front[id].age;
  }
  EXPECT_EQ(front[kept].level, 2) << "edges that stay keep their level";
}

TEST(Front, KeepsOldEdgesWithThePlacesThatTheyLeave) {
  Front front;
  addPolygon(front, kHexagon);
  const PlaceId three = placeOf(front, 3), four = front.next(three), two = front.previous(three);
  Front::Change change;
  replace(front, 0, {existingVertex(front, three)}, change);
  EXPECT_EQ(front.next(three), four);
  EXPECT_EQ(front[front.next(two)].vertex, VertexId(3u));
  for (PlaceId id : {two, three, four})
    EXPECT_EQ(std::count(change.added.begin(), change.added.end(), id), 0);
}

TEST(Front, ReusesPlacesThatWereReleased) {
  Front front;
  addPolygon(front, kHexagon);
  Front::Change change;
  replace(front, 0, {existingVertex(front, placeOf(front, 2))}, change);
  const std::size_t capacity = front.capacity();
  front.release(change);
  replace(front, 0, {newVertex(6, {1, 1})});
  EXPECT_EQ(front.capacity(), capacity);
}

TEST(Front, MeasuresTheFreeAngleAtAPlace) {
  const double right = std::acos(0.0);
  Front front;
  addPolygon(front, {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}});
  EXPECT_NEAR(front.turn(placeOf(front, 0)), right, 1e-14);
  EXPECT_NEAR(front.turn(placeOf(front, 1)), 2 * right, 1e-14);
  addPolygon(front, {{.5, .5}, {.5, 1}, {1, 1}, {1, .5}}, 5);
  EXPECT_NEAR(front.turn(placeOf(front, 5)), 3 * right, 1e-14) << "a hole seen from outside";
  addPolygon(front, {{.2, .2}, {.3, .2}}, 9);
  EXPECT_NEAR(front.turn(placeOf(front, 9)), 4 * right, 1e-14) << "the end of a slit";
}

TEST(Front, LinksLoopsThatTouchInAVertexByTheirFreeSectors) {
  // A triangular hole hangs from the middle of the lower side, vertex 1.
  Front front;
  addPolygon(front, {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}});
  std::vector<BoundaryCorner> hole{flatCorner(1, {2, 0}), flatCorner(5, {1, 2}),
                                   flatCorner(6, {3, 2})};
  front.addLoop(hole, std::vector<double>(3, 1.0));
  front.untangle();
  expectSound(front);
  EXPECT_EQ(loopsOf(front), (Loops{{0, 1, 5, 6, 1, 2, 3, 4}}));
}

TEST(Front, LinksLinesThatMeetInAVertexByTheirFreeSectors) {
  Front front;
  const Point2 ends[]{{1, 0}, {0, 1}, {-1, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<BoundaryCorner> line{flatCorner(0, {0, 0}), flatCorner(1 + i, ends[i])};
    front.addLoop(line, std::vector<double>(2, 1.0));
  }
  front.untangle();
  expectSound(front);
  EXPECT_EQ(loopsOf(front), (Loops{{0, 1, 0, 3, 0, 2}}));
}

TEST(Front, LeavesWalksAsTheyAreThatAreRightAlready) {
  Front front;
  addPolygon(front, kHexagon);
  replace(front, 0, {existingVertex(front, placeOf(front, 3))});
  const Loops before = loopsOf(front);
  front.untangle();
  expectSound(front);
  EXPECT_EQ(loopsOf(front), before);
}

/// How often an edge runs from u to v more often than from v to u.
using NetEdges = std::map<std::pair<std::size_t, std::size_t>, int>;

void addNet(NetEdges& net, std::size_t from, std::size_t to, int count) {
  const bool isUp = from < to;
  int& n = net[isUp ? std::pair(from, to) : std::pair(to, from)];
  n += isUp ? count : -count;
  if (n == 0) net.erase(isUp ? std::pair(from, to) : std::pair(to, from));
}

NetEdges netOf(const Front& front) {
  NetEdges net;
  for (std::size_t i = 0; i < front.capacity(); ++i)
    if (front.hasEdge(PlaceId(i)))
      addNet(net, front[PlaceId(i)].vertex.value, front[front.next(PlaceId(i))].vertex.value, 1);
  return net;
}

TEST(Front, StaysSoundUnderRandomReplacements) {
  std::mt19937 random(2024);
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  for (int round = 0; round < 50; ++round) {
    Front front;
    addPolygon(front, circle({0, 0}, 1, 12));
    addPolygon(front, circle({0, 0}, .5, 5, true), 12);
    std::size_t vertices = 17;
    NetEdges expected = netOf(front);
    for (int n = 0; n < 60 && !front.isEmpty(); ++n) {
      std::vector<PlaceId> edges;
      for (std::size_t i = 0; i < front.capacity(); ++i)
        if (front.hasEdge(PlaceId(i))) edges.push_back(PlaceId(i));
      const PlaceId base = edges[below(edges.size())];
      std::vector<WalkVertex> walk;
      for (std::size_t k = 0, count = 1 + below(3); k < count; ++k) {
        const PlaceId other = edges[below(edges.size())];
        const auto isTaken = [&](VertexId v) {
          return v == front[base].vertex || v == front[front.next(base)].vertex ||
                 std::any_of(walk.begin(), walk.end(),
                             [&](const WalkVertex& w) { return w.vertex == v; });
        };
        walk.push_back(below(2) == 0 || isTaken(front[other].vertex)
                           ? newVertex(vertices++, {0, 0})
                           : existingVertex(front, other));
      }
      addNet(expected, front[base].vertex.value, front[front.next(base)].vertex.value, -1);
      std::size_t from = front[base].vertex.value;
      for (const WalkVertex& w : walk) {
        addNet(expected, from, w.vertex.value, 1);
        from = w.vertex.value;
      }
      addNet(expected, from, front[front.next(base)].vertex.value, 1);
      Front::Change change;
      front.replace(base, walk, change);
      expectSound(front);
      for (PlaceId id : change.added) ASSERT_TRUE(front.hasEdge(id));
      for (PlaceId id : change.removed) ASSERT_FALSE(front.isUsed(id));
      front.release(change);
      ASSERT_EQ(netOf(front), expected) << "round " << round << ", step " << n;
    }
  }
}

}  // namespace
}  // namespace af2
