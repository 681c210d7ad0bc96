// Runs many independent tasks on several threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <ranges>
#include <utility>
#include <vector>

namespace af2 {

/// Calls `work`, whose parallel parts use at most `threads` threads (0: as many as the caller's TBB
/// arena has). Exceptions are passed on.
void withThreads(int threads, const std::function<void()>& work);

/// How many threads run what `threads` asks for here.
int threadCount(int threads);

/// Calls work(0), ..., work(count - 1), each once, started in this order, on up to `threads`
/// threads (0: as many as the caller's TBB arena has). The first exception stops the remaining
/// calls and is passed on.
void forEachInParallel(std::size_t count, int threads,
                       const std::function<void(std::size_t)>& work);

/// Calls take(make(0)), ..., take(make(count - 1)) in this order, where several are made at the
/// same time, but never many ahead.
template <class Make, class Take>
void takeInOrder(std::size_t count, int threads, const Make& make, Take take) {
  constexpr std::size_t kForEachThread = 4;
  const std::size_t atOnce = kForEachThread * static_cast<std::size_t>(threadCount(threads));
  for (std::size_t first = 0; first < count; first += atOnce) {
    std::vector<std::optional<decltype(make(first))>> made(std::min(atOnce, count - first));
    forEachInParallel(made.size(), threads,
                      [&](std::size_t i) { made[i].emplace(make(first + i)); });
    for (auto& one : made) take(std::move(*one));
  }
}

/// The numbers below `count` in consecutive ranges of `size`, of which the last may be shorter.
/// What is found by range and put together in order does not depend on the number of threads.
class Ranges {
 public:
  Ranges(std::size_t count, std::size_t size) : count_(count), size_(size) {}

  std::size_t count() const { return (count_ + size_ - 1) / size_; }
  /// The numbers of a range.
  auto operator[](std::size_t range) const {
    return std::views::iota(range * size_, std::min(count_, (range + 1) * size_));
  }

 private:
  std::size_t count_, size_;
};

/// Calls work(i) for 0 to count - 1: ranges of `size` in parallel, each in order.
template <class Work>
void forEachInRanges(std::size_t count, std::size_t size, int threads, const Work& work) {
  const Ranges ranges(count, size);
  forEachInParallel(ranges.count(), threads, [&](std::size_t range) {
    for (const std::size_t i : ranges[range]) work(i);
  });
}

}  // namespace af2
