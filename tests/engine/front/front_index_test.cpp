#include "engine/front/front_index.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/support/fronts.h"

namespace af2 {
namespace {

using namespace af2::testing;

BoundaryCorner cornerAt(std::size_t id, const Point3& p) {
  return {VertexId(id), {p, {0, 0, 1}, 0, 0}};
}

/// Adds p -> q -> p; returns the place of p -> q.
PlaceId addEdgePair(Front& front, const Point3& p, const Point3& q) {
  const std::size_t id = front.capacity();
  const std::vector<BoundaryCorner> corners{cornerAt(id, p), cornerAt(id + 1, q)};
  return front.addLoop(corners, std::vector<double>(2, 1.0));
}

bool boxesMeet(const Point3& p, const Point3& q, const Box3& box) {
  return std::max(p.x, q.x) >= box.low.x && std::min(p.x, q.x) <= box.high.x &&
         std::max(p.y, q.y) >= box.low.y && std::min(p.y, q.y) <= box.high.y &&
         std::max(p.z, q.z) >= box.low.z && std::min(p.z, q.z) <= box.high.z;
}

std::vector<PlaceId> edgesNear(const FrontIndex& index, const Box3& box) {
  std::vector<PlaceId> found;
  found.resize(index.collectNear(box, found).count);
  return found;
}

/// Every edge in the index whose box meets `box` is visited, none twice, none that is not in it.
void expectFindsAll(const Front& front, const FrontIndex& index, const std::set<PlaceId>& inIndex,
                    const Box3& box) {
  std::set<PlaceId> found;
  for (PlaceId id : edgesNear(index, box)) {
    EXPECT_TRUE(found.insert(id).second) << "found twice";
    EXPECT_TRUE(inIndex.contains(id)) << "not in the index";
  }
  for (PlaceId id : inIndex) {
    const bool isNear =
        boxesMeet(front[id].point.position, front[front.next(id)].point.position, box);
    EXPECT_TRUE(!isNear || found.contains(id)) << "edge " << id.value << " was missed";
  }
}

struct IndexCase {
  const char* name;
  double extent, shortest, longest;
  Point3 center;
};

class RandomIndex : public ::testing::TestWithParam<IndexCase> {};

TEST_P(RandomIndex, FindsWhatABruteForceSearchFinds) {
  const IndexCase& c = GetParam();
  std::mt19937 random(123);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&](const Point3& center, double reach) {
    return center + reach * Point3{unit(random), unit(random), unit(random)};
  };
  const auto length = [&] {
    const double t = 0.5 * (1 + unit(random));
    return c.shortest * std::pow(c.longest / c.shortest, t);
  };
  const Point3 half{c.extent, c.extent, c.extent};
  FrontIndex index({c.center - half, c.center + half}, std::sqrt(c.shortest * c.longest));
  Front front;
  std::set<PlaceId> inIndex;
  std::vector<PlaceId> outside;
  for (int i = 0; i < 300; ++i) {
    const Point3 p = point(c.center, c.extent);
    const PlaceId id = addEdgePair(front, p, point(p, length()));
    outside.push_back(id);
    outside.push_back(PlaceId(id.value + 1));
  }
  for (int step = 0; step < 3000; ++step) {
    if (!outside.empty() && (inIndex.empty() || unit(random) > -.2)) {
      const std::size_t k = random() % outside.size();
      index.insert(front, outside[k]);
      inIndex.insert(outside[k]);
      outside.erase(outside.begin() + static_cast<std::ptrdiff_t>(k));
    } else {
      auto it = inIndex.begin();
      std::advance(it, static_cast<std::ptrdiff_t>(random() % inIndex.size()));
      index.erase(*it);
      outside.push_back(*it);
      inIndex.erase(it);
    }
    if (step % 10 != 0) continue;
    const Point3 p = point(c.center, 1.2 * c.extent);
    const double reach = length();
    expectFindsAll(front, index, inIndex,
                   {p - Point3{reach, reach, reach}, p + Point3{reach, reach, reach}});
  }
}

INSTANTIATE_TEST_SUITE_P(
    FrontIndex, RandomIndex,
    ::testing::Values(IndexCase{"Uniform", 10, 1, 1.2, {0, 0, 0}},
                      IndexCase{"Graded1To1000", 10, .003, 3, {0, 0, 0}},
                      IndexCase{"NegativeCoordinates", 10, .5, 2, {-1000, -1000, -1000}},
                      IndexCase{"FarOffset", 10, .5, 2, {1e6, -1e6, 1e6}},
                      IndexCase{"Tiny", 1e-8, 1e-9, 2e-9, {0, 0, 0}},
                      IndexCase{"Huge", 1e10, 1e9, 2e9, {0, 0, 0}},
                      IndexCase{"WideAndGraded", 1e4, 1e-2, 10, {0, 0, 0}}),
    [](const auto& c) { return c.param.name; });

TEST(FrontIndex, FindsSmallEdgesFarFromTheCornerOfAWideBox) {
  // 10000 typical lengths wide, edges of a thousandth of the typical length at the far end.
  FrontIndex index({{0, 0, 0}, {1e4, 1e4, 0}}, 1);
  Front front;
  std::set<PlaceId> inIndex;
  for (double x : {1.0, 5e3, 9e3, 9999.0}) {
    const PlaceId id = addEdgePair(front, {x, x, 0}, {x + 1e-3, x, 0});
    index.insert(front, id);
    inIndex.insert(id);
  }
  for (double x : {1.0, 5e3, 9e3, 9999.0})
    expectFindsAll(front, index, inIndex, {{x - .01, x - .01, -.01}, {x + .01, x + .01, .01}});
}

TEST(FrontIndex, FindsVerticesWithoutAnEdge) {
  FrontIndex index({{0, 0, 0}, {1, 1, 0}}, .1);
  Front front;
  const PlaceId id = front.addIsolated(cornerAt(0, {.5, .5, 0}), .1);
  index.insert(front, id);
  expectFindsAll(front, index, {id}, {{.4, .4, 0}, {.6, .6, 0}});
}

TEST(FrontIndex, IgnoresTheErasureOfAnEdgeThatIsNotInIt) {
  FrontIndex index({{0, 0, 0}, {1, 1, 0}}, 1);
  Front front;
  const PlaceId id = addEdgePair(front, {0, 0, 0}, {1, 0, 0});
  index.erase(id);
  index.insert(front, id);
  index.erase(id);
  index.erase(id);
  expectFindsAll(front, index, {}, {{-1, -1, -1}, {2, 2, 1}});
}

TEST(FrontIndex, FindsALongEdgeFromAnyOfItsPoints) {
  FrontIndex index({{0, 0, 0}, {100, 100, 0}}, 1);
  Front front;
  const PlaceId id = addEdgePair(front, {0, 50, 0}, {100, 50, 0});
  index.insert(front, id);
  for (double x = 0; x <= 100; x += 1)
    expectFindsAll(front, index, {id}, {{x, 49.9, 0}, {x + .1, 50.1, 0}});
}

TEST(FrontIndex, DoesNotLookAtShortEdgesFarFromALongOne) {
  // Short edges around a square of a thousand lengths; the search is inside.
  FrontIndex index({{0, 0, 0}, {1000, 1000, 0}}, 1);
  Front front;
  std::set<PlaceId> inIndex;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < 1000; ++i) {
      const Point3 p{1. * i, side == 0 ? 0. : 1000., 0};
      const Point3 at = side < 2 ? p : Point3{p.y - (side == 2 ? 0 : 1000), p.x, 0};
      const PlaceId id = addEdgePair(front, at, at + Point3{.7, .7, 0});
      index.insert(front, id);
      inIndex.insert(id);
    }
  }
  const Box3 inside{{100, 100, -100}, {900, 900, 100}};
  std::vector<PlaceId> found;
  EXPECT_LT(index.collectNear(inside, found).lookedAt, inIndex.size() / 4);
  expectFindsAll(front, index, inIndex, inside);
  const Box3 atTheSide{{-100, 400, -100}, {300, 600, 100}};
  EXPECT_LT(index.collectNear(atTheSide, found).lookedAt, inIndex.size() / 4);
  expectFindsAll(front, index, inIndex, atTheSide);
}

TEST(FrontIndex, FindsInAnOrderThatDependsOnItsHistoryAlone) {
  const auto visit = [] {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0, 10);
    FrontIndex index({{0, 0, 0}, {10, 10, 0}}, 1);
    Front front;
    for (int i = 0; i < 200; ++i) {
      const Point3 p{unit(random), unit(random), 0};
      index.insert(front, addEdgePair(front, p, p + Point3{.9, .1, 0}));
    }
    for (int i = 0; i < 200; i += 6) index.erase(PlaceId(static_cast<std::size_t>(2 * i)));
    return edgesNear(index, {{2, 2, 0}, {8, 8, 0}});
  };
  EXPECT_EQ(visit(), visit());
  EXPECT_FALSE(visit().empty());
}

}  // namespace
}  // namespace af2
