// What AF2 uses of oneTBB, one task after the other.
#pragma once

namespace tbb {

namespace info {
inline int default_concurrency() { return 1; }
}  // namespace info

namespace this_task_arena {
inline int max_concurrency() { return 1; }
}  // namespace this_task_arena

class task_arena {
 public:
  explicit task_arena(int) {}
  template <class Work>
  void execute(const Work& work) {
    work();
  }
};

class task_group {
 public:
  template <class Work>
  void run(const Work& work) {
    work();
  }
  template <class Work>
  void run_and_wait(const Work& work) {
    work();
  }
};

struct simple_partitioner {};

template <class Index, class Work>
void parallel_for(Index first, Index last, const Work& work, simple_partitioner) {
  for (; first < last; ++first) work(first);
}

}  // namespace tbb
