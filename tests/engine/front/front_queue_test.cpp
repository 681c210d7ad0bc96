#include "engine/front/front_queue.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "engine/base/error.h"
#include "tests/support/fronts.h"

namespace af2 {
namespace {

using namespace af2::testing;

/// A user's own order that says the same as another one.
class OpenOrder final : public AF2FrontOrder {
 public:
  explicit OpenOrder(const AF2FrontOrder& order) : order_(order) {}
  int keyCount() const override { return order_.keyCount(); }
  double key(int index, const FrontEdgeFacts& edge) const override {
    return order_.key(index, edge);
  }

 private:
  const AF2FrontOrder& order_;
};

class ShortestWithinLevel final : public AF2FrontOrder {
  int keyCount() const override { return 2; }
  double key(int index, const FrontEdgeFacts& e) const override {
    return index == 0 ? e.level : e.length;
  }
  bool needsTurns() const override { return false; }
};

class SmallestTurn final : public AF2FrontOrder {
  int keyCount() const override { return 1; }
  double key(int, const FrontEdgeFacts& e) const override { return e.turnA + e.turnB; }
};

/// An order that keys cannot say, all in one place: the edge that entered last comes first.
class NewestFirst final : public AF2FrontOrder {
  class Stack final : public AF2EdgeQueue {
    void push(const Front& front, PlaceId place) override {
      waiting_.emplace_back(place, front[place].age);
    }
    PlaceId pop(const Front& front) override {
      while (!waiting_.empty()) {
        const auto [place, age] = waiting_.back();
        waiting_.pop_back();
        if (front.isUsed(place) && front[place].age == age) return place;
      }
      return {};
    }
    std::vector<std::pair<PlaceId, std::uint32_t>> waiting_;
  };
  std::unique_ptr<AF2EdgeQueue> makeQueue() const override { return std::make_unique<Stack>(); }
};

std::vector<std::size_t> popAll(FrontQueue& queue, const Front& front) {
  std::vector<std::size_t> order;
  for (PlaceId id = queue.pop(front); !id.isNone(); id = queue.pop(front))
    order.push_back(front[id].vertex.value);
  return order;
}

TEST(FrontQueue, IsEmptyAtFirst) {
  const LayeredFrontOrder order(1, 1, 1);
  FrontQueue queue(order);
  EXPECT_TRUE(queue.pop(Front()).isNone());
}

TEST(FrontQueue, TakesSmallKeysFirstAndAmongEqualKeysTheFirstThatEntered) {
  Front front;
  addPolygon(front, circle({0, 0}, 1, 6));
  front[PlaceId(1u)].layer = 2;  // edges 0 and 1 have it
  front.raiseLevel(PlaceId(4u));
  const LayeredFrontOrder order(1, 1, 1);
  for (bool isOpen : {false, true}) {
    const OpenOrder open(order);
    FrontQueue queue(isOpen ? static_cast<const AF2FrontOrder&>(open) : order);
    pushAll(queue, front);
    EXPECT_EQ(popAll(queue, front), (std::vector<std::size_t>{2, 3, 5, 4, 0, 1}));
  }
}

TEST(FrontQueue, TakesAnEdgeWithASmallKeyThatEntersLate) {
  Front front;
  addPolygon(front, circle({0, 0}, 1, 4));
  for (std::size_t i : {1u, 2u, 3u}) front.raiseLevel(PlaceId(i));
  const LayeredFrontOrder order(1, 1, 1);
  FrontQueue queue(order);
  for (std::size_t i : {1u, 2u, 3u}) queue.push(front, PlaceId(i));
  EXPECT_EQ(queue.pop(front), PlaceId(1u));
  queue.push(front, PlaceId(0u));
  EXPECT_EQ(queue.pop(front), PlaceId(0u));
  EXPECT_EQ(queue.pop(front), PlaceId(2u));
}

TEST(FrontQueue, ForgetsEdgesThatHaveLeftTheFront) {
  Front front;
  addPolygon(front, circle({0, 0}, 1, 6));
  const LayeredFrontOrder order(1, 1, 1);
  for (bool isOpen : {false, true}) {
    Front copy = front;
    const OpenOrder open(order);
    FrontQueue queue(isOpen ? static_cast<const AF2FrontOrder&>(open) : order);
    pushAll(queue, copy);
    Front::Change change;
    // Fills the corner 0, 1, 2: the edges 0 and 1 leave, a new one leaves the place of 0.
    const std::vector<WalkVertex> walk{existingVertex(copy, PlaceId(2u))};
    copy.replace(PlaceId(0u), walk, change);
    copy.release(change);
    EXPECT_EQ(popAll(queue, copy), (std::vector<std::size_t>{2, 3, 4, 5}));
  }
}

TEST(FrontQueue, DoesNotTakeAReusedPlaceForTheEdgeThatLeft) {
  Front front;
  addPolygon(front, circle({0, 0}, 1, 6));
  const LayeredFrontOrder order(1, 1, 1);
  FrontQueue queue(order);
  pushAll(queue, front);
  Front::Change change;
  const std::vector<WalkVertex> fill{existingVertex(front, PlaceId(2u))};
  front.replace(PlaceId(0u), fill, change);
  front.release(change);
  const std::vector<WalkVertex> bulge{newVertex(9, {0, 0})};
  front.replace(PlaceId(3u), bulge, change);
  for (PlaceId id : change.added) queue.push(front, id);
  EXPECT_EQ(popAll(queue, front), (std::vector<std::size_t>{2, 4, 5, 3, 9}));
}

TEST(FrontQueue, ComparesKeysLexicographically) {
  Front front;
  addPolygon(front, {{0, 0}, {3, 0}, {3, 1}, {0, 2}});  // lengths 3, 1, sqrt 10, 2
  front.raiseLevel(PlaceId(1u));
  const ShortestWithinLevel order;
  FrontQueue queue(order);
  pushAll(queue, front);
  EXPECT_EQ(popAll(queue, front), (std::vector<std::size_t>{3, 0, 2, 1}));
}

TEST(FrontQueue, KnowsTheFreeAnglesAtTheEndsOfAnEdge) {
  Front front;
  addPolygon(front, {{0, 0}, {4, 0}, {4, 4}, {2, 1}});
  const SmallestTurn order;
  FrontQueue queue(order);
  pushAll(queue, front);
  EXPECT_EQ(popAll(queue, front).front(), 0u);
}

TEST(FrontQueue, GivesTheSameOrderInItsFastAndItsOpenForm) {
  std::mt19937 random(77);
  const LayeredFrontOrder order(2, 1, 3);
  const OpenOrder open(order);
  for (int round = 0; round < 50; ++round) {
    Front front;
    addPolygon(front, circle({0, 0}, 1, 40));
    for (std::size_t i = 0; i < 40; ++i) {
      front[PlaceId(i)].layer = static_cast<std::int32_t>(random() % 4);
      front[PlaceId(i)].level = static_cast<std::int32_t>(1 + random() % 4);
    }
    FrontQueue fast(order), slow(open);
    for (int n = 0; n < 200; ++n) {
      if (random() % 3 > 0) {
        const PlaceId id(random() % 40);
        fast.push(front, id);
        slow.push(front, id);
      } else {
        ASSERT_EQ(fast.pop(front), slow.pop(front));
      }
    }
    ASSERT_EQ(popAll(fast, front), popAll(slow, front));
  }
}

TEST(FrontQueue, ComputesKeysOfTurnsAgainWhenAnEndGetsAnotherNeighbour) {
  Front front;
  addPolygon(front, circle({0, 0}, 1, 6));
  const SmallestTurn order;
  FrontQueue queue(order);
  for (std::size_t i = 0; i < 6; ++i) queue.push(front, PlaceId(i));
  EXPECT_TRUE(queue.isRenewed());
  // The corner at 4 becomes sharp: the edges on both sides of it come first.
  front[PlaceId(4)].point.position = 3.0 * front[PlaceId(4)].point.position;
  for (std::size_t i = 2; i < 6; ++i) queue.renew(front, PlaceId(i));
  const std::vector<std::size_t> popped = popAll(queue, front);
  EXPECT_EQ(popped.size(), 6u);
  EXPECT_EQ(std::set<std::size_t>(popped.begin(), popped.begin() + 2),
            (std::set<std::size_t>{3, 4}));
}

TEST(FrontQueue, LeavesAnOrderThatKeysCannotSayToItsOwnQueue) {
  Front front;
  addPolygon(front, circle({0, 0}, 1, 4));
  const NewestFirst order;
  FrontQueue queue(order);
  pushAll(queue, front);
  EXPECT_EQ(popAll(queue, front), (std::vector<std::size_t>{3, 2, 1, 0}));
}

TEST(LayeredFrontOrder, RejectsCoefficientsOutOfRange) {
  EXPECT_THROW(LayeredFrontOrder(-1, 0, 0), InputError);
  EXPECT_THROW(LayeredFrontOrder(0, 1001, 0), InputError);
  EXPECT_THROW(LayeredFrontOrder(0, 0, 1001), InputError);
  EXPECT_NO_THROW(LayeredFrontOrder(0, 0, 0));
}

}  // namespace
}  // namespace af2
