// Groups items that belong together (union-find).
// Not installed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace af2::geometry {

/// Items by number, each in a set of its own at first. The lowest number of a set represents it.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : up_(count) { std::iota(up_.begin(), up_.end(), 0u); }
  std::uint32_t of(std::uint32_t i) {
    while (up_[i] != i) i = up_[i] = up_[up_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t first = of(i), second = of(j);
    up_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> up_;
};

}  // namespace af2::geometry
