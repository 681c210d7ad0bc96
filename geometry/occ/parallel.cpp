#include "geometry/occ/parallel.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>

namespace af2::geometry {

void forEachInParallel(std::size_t count, int threads,
                       const std::function<void(std::size_t)>& work) {
  // More threads than cores bring nothing, and TBB would print a warning.
  const int cores = tbb::info::default_concurrency();
  const int workers = threads > 0 ? std::min(threads, cores) : cores;
  if (workers == 1 || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  // A counter instead of ranges: things are to be started in order, the largest first.
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
  tbb::task_arena arena(workers);
  arena.execute([&] {
    tbb::task_group group;
    for (int i = 1; i < workers; ++i) group.run(takeAll);
    group.run_and_wait(takeAll);
  });
}

}  // namespace af2::geometry
