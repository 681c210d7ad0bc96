#include "geometry/edges/odd_nodes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/base/disjoint_sets.h"

namespace af2::geometry {

namespace {

class Joiner {
 public:
  Joiner(std::vector<bool> isOdd, std::size_t freeNode, const std::vector<NodeLink>& links)
      : isOdd_(std::move(isOdd)),
        freeNode_(freeNode),
        links_(links),
        isChosen_(links.size(), false) {}

  std::vector<bool> join() {
    constexpr int kMaxRounds = 20;  // two or three are usual
    makeForest();
    chooseInForest();
    bool isBetter = true;
    for (int round = 0; round < kMaxRounds && isBetter; ++round) {
      makeForest();
      isBetter = exchange();
    }
    return std::move(isChosen_);
  }

 private:
  struct Way {
    std::size_t link = 0, node = 0;
  };

  /// A spanning forest: chosen links first, then by weight.
  void makeForest() {
    std::vector<std::size_t> order(links_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(
        order, {}, [&](std::size_t i) { return std::tuple(!isChosen_[i], links_[i].weight, i); });
    DisjointSets joined(isOdd_.size());
    isInForest_.assign(links_.size(), false);
    ways_.assign(isOdd_.size(), {});
    for (const std::size_t i : order) {
      const auto [from, to, weight] = links_[i];
      const auto a = static_cast<std::uint32_t>(from), b = static_cast<std::uint32_t>(to);
      if (joined.of(a) == joined.of(b)) continue;
      joined.join(a, b);
      isInForest_[i] = true;
      ways_[from].push_back({i, to});
      ways_[to].push_back({i, from});
    }
    directForest();
  }

  /// From the free node, then from the lowest node of each other tree.
  void directForest() {
    up_.assign(isOdd_.size(), std::nullopt);
    depth_.assign(isOdd_.size(), kUnseen);
    fromRoots_.clear();
    descendFrom(freeNode_);
    for (std::size_t node = 0; node < isOdd_.size(); ++node)
      if (depth_[node] == kUnseen) descendFrom(node);
  }

  void descendFrom(std::size_t root) {
    std::size_t next = fromRoots_.size();
    depth_[root] = 0;
    fromRoots_.push_back(root);
    for (; next < fromRoots_.size(); ++next) {
      const std::size_t node = fromRoots_[next];
      for (const Way& way : ways_[node]) {
        if (depth_[way.node] != kUnseen) continue;
        depth_[way.node] = depth_[node] + 1;
        up_[way.node] = Way{way.link, node};
        fromRoots_.push_back(way.node);
      }
    }
  }

  void chooseInForest() {
    std::vector<bool> isOdd = isOdd_;
    for (std::size_t k = fromRoots_.size(); k-- > 0;) {
      const std::size_t node = fromRoots_[k];
      if (!isOdd[node] || !up_[node]) continue;
      isChosen_[up_[node]->link] = true;
      isOdd[up_[node]->node] = !isOdd[up_[node]->node];
    }
  }

  /// Whether an exchange along some cycle lowered the weight.
  bool exchange() {
    bool isBetter = false;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (isInForest_[i]) continue;
      findCycle(i);
      if (!lowersWeight()) continue;
      for (const std::size_t link : cycle_) isChosen_[link] = !isChosen_[link];
      isBetter = true;
    }
    return isBetter;
  }

  /// The link and the path in the forest between its ends.
  void findCycle(std::size_t link) {
    cycle_.assign(1, link);
    std::size_t a = links_[link].from, b = links_[link].to;
    while (a != b) {
      std::size_t& lower = depth_[a] >= depth_[b] ? a : b;
      cycle_.push_back(up_[lower]->link);
      lower = up_[lower]->node;
    }
  }

  bool lowersWeight() const {
    constexpr double kRounding = 1e-9;
    double change = 0, all = 0;
    for (const std::size_t link : cycle_) {
      change += isChosen_[link] ? -links_[link].weight : links_[link].weight;
      all += links_[link].weight;
    }
    return change < -kRounding * all;
  }

  static constexpr std::size_t kUnseen = static_cast<std::size_t>(-1);

  const std::vector<bool> isOdd_;
  const std::size_t freeNode_;
  const std::vector<NodeLink>& links_;
  std::vector<bool> isChosen_, isInForest_;  // by link
  std::vector<std::vector<Way>> ways_;       // by node: in the forest
  std::vector<std::optional<Way>> up_;       // by node: towards the root of its tree
  std::vector<std::size_t> depth_;           // by node: below that root
  std::vector<std::size_t> fromRoots_;       // nodes; each comes after the one above it
  std::vector<std::size_t> cycle_;           // links
};

}  // namespace

std::vector<bool> joinOddNodes(std::vector<bool> isOdd, std::size_t freeNode,
                               const std::vector<NodeLink>& links) {
  return Joiner(std::move(isOdd), freeNode, links).join();
}

}  // namespace af2::geometry
