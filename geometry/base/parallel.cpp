#include "geometry/base/parallel.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>

namespace af2::geometry {

namespace {

/// A counter instead of ranges, because tasks must be started in order, the largest first.
void runAll(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto takeAll = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        next = count;
        throw;
      }
    }
  };
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  tbb::task_group group;
  for (std::size_t i = 1; i < std::min(threads, count); ++i) group.run(takeAll);
  group.run_and_wait(takeAll);
}

}  // namespace

void withThreads(int threads, const std::function<void()>& work) {
  if (threads <= 0) return work();
  // More threads than cores bring nothing, and TBB would print a warning. An arena is wanted for a
  // single thread, too: it holds for what the work does in parallel by itself.
  tbb::task_arena(std::min(threads, tbb::info::default_concurrency())).execute(work);
}

int threadCount(int threads) {
  const int all = tbb::this_task_arena::max_concurrency();
  return threads <= 0 ? all : std::min(threads, all);
}

void forEachInParallel(std::size_t count, int threads,
                       const std::function<void(std::size_t)>& work) {
  withThreads(threads, [&] { runAll(count, work); });
}

}  // namespace af2::geometry
