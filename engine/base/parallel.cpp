#include "engine/base/parallel.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace af2 {

namespace {

/// Whether this thread does its work alone. To start TBB for that would take half a millisecond.
thread_local bool isAlone = false;

class Alone {
 public:
  explicit Alone(bool is) : before_(std::exchange(isAlone, is)) {}
  ~Alone() { isAlone = before_; }
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;

 private:
  bool before_;
};

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
  const std::size_t threads = std::min(static_cast<std::size_t>(threadCount(0)), count);
  if (threads <= 1) return takeAll();
  // Isolated: if work is called from work of another loop, an exception there must not leave out
  // calls here, whose results the caller uses.
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::task_group group(context);
  for (std::size_t i = 1; i < threads; ++i) group.run(takeAll);
  group.run_and_wait(takeAll);
}

}  // namespace

void withThreads(int threads, const std::function<void()>& work) {
  if (threads <= 0) return work();
  const Alone alone(threads == 1);
  if (threads == 1) return work();
  // More threads than cores bring nothing, and TBB would print a warning.
  tbb::task_arena(std::min(threads, tbb::info::default_concurrency())).execute(work);
}

int threadCount(int threads) {
  if (isAlone || threads == 1) return 1;
  const int all = tbb::this_task_arena::max_concurrency();
  return threads <= 0 ? all : std::min(threads, all);
}

void forEachInParallel(std::size_t count, int threads,
                       const std::function<void(std::size_t)>& work) {
  withThreads(threads, [&] { runAll(count, work); });
}

}  // namespace af2
