#include <gtest/gtest.h>

#include "engine/front/front_queue.h"
#include "engine/front/row_order.h"
#include "tests/support/fronts.h"

namespace af2 {
namespace {

using namespace af2::testing;
using Vertices = std::vector<std::size_t>;

const RowFrontOrder kFromSmallestTurn(RowStart::SmallestTurn), kFromOldest(RowStart::Oldest);

/// Vertices from which the edges leave that come next, at most so many.
Vertices pop(FrontQueue& queue, const Front& front, std::size_t most = 99) {
  Vertices order;
  while (order.size() < most) {
    const PlaceId id = queue.pop(front);
    if (id.isNone()) break;
    order.push_back(front[id].vertex.value);
  }
  return order;
}

/// Covers the edge that leaves a vertex by a triangle with a new apex, as the engine would.
void cover(FrontQueue& queue, Front& front, std::size_t vertex, std::size_t apex, Point2 at) {
  Front::Change change;
  const std::vector<WalkVertex> walk{newVertex(apex, at)};
  front.replace(placeOf(front, vertex), walk, change);
  front.release(change);
  for (PlaceId id : change.added) queue.push(front, id);
}

void refuse(FrontQueue& queue, Front& front, std::size_t vertex) {
  front.raiseLevel(placeOf(front, vertex));
  queue.push(front, placeOf(front, vertex));
}

TEST(RowFrontOrder, IsEmptyAtFirst) {
  FrontQueue queue(kFromSmallestTurn);
  EXPECT_TRUE(queue.pop(Front()).isNone());
}

TEST(RowFrontOrder, GoesAroundTheLoopFromTheSmallestTurn) {
  Front front;
  addPolygon(front, {{0, 0}, {2, 0}, {4, 0}, {1, 2}, {0, 2}});  // sharpest at vertex 2
  FrontQueue queue(kFromSmallestTurn);
  pushAll(queue, front);
  EXPECT_EQ(pop(queue, front), (Vertices{2, 3, 4, 0, 1}));
}

TEST(RowFrontOrder, OfEqualTurnsThatOfTheOldestEdgeIsFirst) {
  Front front;
  addPolygon(front, {{0.5, 0}, {1, 0}, {1, 1}, {0.3, 1}, {0, 1}, {0, 0}});  // corners 1, 2, 4, 5
  FrontQueue queue(kFromSmallestTurn);
  pushAll(queue, front);
  EXPECT_EQ(pop(queue, front), (Vertices{1, 2, 3, 4, 5, 0}));
}

TEST(RowFrontOrder, MayBeginAtTheOldestEdge) {
  Front front;
  addPolygon(front, {{0, 0}, {2, 0}, {4, 0}, {1, 2}, {0, 2}});
  FrontQueue queue(kFromOldest);
  for (std::size_t i : {3u, 0u, 4u, 1u, 2u}) queue.push(front, PlaceId(i));
  EXPECT_EQ(pop(queue, front), (Vertices{3, 4, 0, 1, 2}));
}

TEST(RowFrontOrder, LeavesWhatJoinsTheFrontToTheNextRow) {
  Front front;
  addPolygon(front, circle({0, 0}, 2, 5));
  FrontQueue queue(kFromOldest);
  pushAll(queue, front);
  EXPECT_EQ(pop(queue, front, 1), Vertices{0});
  cover(queue, front, 0, 10, {1, 0.8});
  EXPECT_EQ(pop(queue, front, 1), Vertices{1});
  cover(queue, front, 1, 11, {-0.2, 1.2});
  EXPECT_EQ(pop(queue, front), (Vertices{2, 3, 4, 0, 10, 1, 11}));
}

TEST(RowFrontOrder, TakesTheLoopsInTurn) {
  Front front;
  addPolygon(front, circle({0, 0}, 1, 3));
  addPolygon(front, circle({9, 0}, 1, 3), 3);
  FrontQueue queue(kFromOldest);
  pushAll(queue, front);
  EXPECT_EQ(pop(queue, front, 1), Vertices{0});
  cover(queue, front, 0, 10, {0.1, 0.1});
  EXPECT_EQ(pop(queue, front), (Vertices{1, 2, 3, 4, 5, 0, 10}));
}

TEST(RowFrontOrder, WalksAgainOverWhatWasRefusedWhileTheRowGetsOn) {
  Front front;
  addPolygon(front, circle({0, 0}, 2, 5));
  FrontQueue queue(kFromOldest);
  pushAll(queue, front);
  for (std::size_t v : {0u, 1u, 2u, 3u, 4u}) {
    ASSERT_EQ(pop(queue, front, 1), Vertices{v});
    if (v == 2)
      cover(queue, front, v, 10, {-1.1, 0});
    else
      refuse(queue, front, v);
  }
  // One edge was taken: the other four are tried again. Then none is, so the next row has them all.
  for (std::size_t v : {0u, 1u, 3u, 4u}) {
    ASSERT_EQ(pop(queue, front, 1), Vertices{v});
    refuse(queue, front, v);
  }
  EXPECT_EQ(pop(queue, front), (Vertices{0, 1, 2, 10, 3, 4}));
}

TEST(RowFrontOrder, ForgetsEdgesThatHaveLeftTheFrontAndTheirPlaces) {
  Front front;
  addPolygon(front, circle({0, 0}, 1, 6));
  FrontQueue queue(kFromOldest);
  pushAll(queue, front);
  Front::Change change;
  const std::vector<WalkVertex> fill{existingVertex(front, PlaceId(2u))};  // takes edges 0 and 1
  front.replace(PlaceId(0u), fill, change);
  front.release(change);
  cover(queue, front, 3, 9, {0, 0});  // uses a place of those again
  EXPECT_EQ(pop(queue, front), (Vertices{2, 3, 9, 4, 5}));
}

}  // namespace
}  // namespace af2
