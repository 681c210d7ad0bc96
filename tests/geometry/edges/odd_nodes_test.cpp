#include "geometry/edges/odd_nodes.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <random>

namespace af2::geometry {
namespace {

/// The total weight of the chosen links; none if they do not fit the odd nodes.
std::optional<double> weightOf(const std::vector<bool>& isOdd, std::size_t freeNode,
                               const std::vector<NodeLink>& links,
                               const std::vector<bool>& isChosen) {
  std::vector<bool> isLeft = isOdd;
  double weight = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (!isChosen[i]) continue;
    weight += links[i].weight;
    isLeft[links[i].from] = !isLeft[links[i].from];
    isLeft[links[i].to] = !isLeft[links[i].to];
  }
  for (std::size_t node = 0; node < isLeft.size(); ++node)
    if (node != freeNode && isLeft[node]) return std::nullopt;
  return weight;
}

double leastWeight(const std::vector<bool>& isOdd, std::size_t freeNode,
                   const std::vector<NodeLink>& links) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t chosen = 0; chosen < (std::size_t(1) << links.size()); ++chosen) {
    std::vector<bool> isChosen;
    for (std::size_t i = 0; i < links.size(); ++i) isChosen.push_back((chosen >> i) & 1);
    least = std::min(least, weightOf(isOdd, freeNode, links, isChosen).value_or(least));
  }
  return least;
}

TEST(OddNodes, AreJoinedByTheLightestPath) {
  // Around a square from 0 to 2; node 4 is free and far away.
  const std::vector<NodeLink> links{{0, 1, 1}, {1, 2, 1}, {2, 3, 3}, {3, 0, 0.5}, {0, 4, 9}};
  EXPECT_EQ(joinOddNodes({true, false, true, false, false}, 4, links),
            (std::vector<bool>{true, true, false, false, false}));
}

TEST(OddNodes, MayEndAtTheFreeNode) {
  const std::vector<NodeLink> links{{0, 1, 5}, {0, 2, 1}, {1, 2, 1}};
  EXPECT_EQ(joinOddNodes({true, true, false}, 2, links), (std::vector<bool>{false, true, true}));
  EXPECT_EQ(joinOddNodes({true, false, false}, 2, links), (std::vector<bool>{false, true, false}));
}

TEST(OddNodes, UseALinkOutsideTheForestWhereThatIsLighter) {
  // The chain 0-1-2-3 is lighter link by link, the direct link 0-3 is lighter as a whole.
  const std::vector<NodeLink> links{{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {0, 3, 2}};
  EXPECT_EQ(joinOddNodes({true, false, false, true, false}, 4, links),
            (std::vector<bool>{false, false, false, true}));
}

TEST(OddNodes, TakeTheFirstOfEqualLinks) {
  const std::vector<NodeLink> links{{0, 1, 1}, {0, 1, 1}};
  EXPECT_EQ(joinOddNodes({true, true, false}, 2, links), (std::vector<bool>{true, false}));
}

TEST(OddNodes, AreJoinedWithAlmostTheLeastWeight) {
  std::mt19937 random(11);
  constexpr int kCases = 300;
  int best = 0;
  for (int k = 0; k < kCases; ++k) {
    const std::size_t nodes = 4 + static_cast<std::size_t>(k) % 5, freeNode = nodes - 1;
    std::vector<NodeLink> links;
    for (std::size_t node = 1; node < nodes; ++node)
      links.push_back({random() % node, node, 1.0 + random() % 100});
    while (links.size() < 12) {
      const std::size_t from = random() % nodes, to = random() % nodes;
      if (from != to) links.push_back({from, to, 1.0 + random() % 100});
    }
    std::vector<bool> isOdd;
    for (std::size_t node = 0; node < nodes; ++node) isOdd.push_back(random() % 2 == 0);
    const auto weight = weightOf(isOdd, freeNode, links, joinOddNodes(isOdd, freeNode, links));
    ASSERT_TRUE(weight) << "case " << k;
    const double least = leastWeight(isOdd, freeNode, links);
    best += *weight <= least;
    EXPECT_LE(*weight, 1.5 * least) << "case " << k;
  }
  RecordProperty("best", best);
  EXPECT_GE(best, kCases * 95 / 100);
}

}  // namespace
}  // namespace af2::geometry
