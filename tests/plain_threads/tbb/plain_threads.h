// What AF2 uses of oneTBB, done with plain threads. ThreadSanitizer follows those; it does not see
// how the threads of a library that was built without it wait for each other, and reports races
// that are none. For the preset `tsan`.
#pragma once

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tbb {

namespace info {
inline int default_concurrency() {
  constexpr unsigned kFewest = 2;  // or there would be nothing to find
  return static_cast<int>(std::max(std::thread::hardware_concurrency(), kFewest));
}
}  // namespace info

namespace plain {
inline thread_local int concurrency = 0;  ///< 0: the default
}

namespace this_task_arena {
inline int max_concurrency() {
  return plain::concurrency > 0 ? plain::concurrency : info::default_concurrency();
}
}  // namespace this_task_arena

class task_arena {
 public:
  explicit task_arena(int threads) : threads_(threads) {}
  template <class Work>
  void execute(const Work& work) {
    const int before = std::exchange(plain::concurrency, threads_);
    work();
    plain::concurrency = before;
  }

 private:
  int threads_;
};

class task_group {
 public:
  template <class Work>
  void run(const Work& work) {
    threads_.emplace_back([this, &work, concurrency = plain::concurrency] {
      plain::concurrency = concurrency;
      guarded(work);
    });
  }
  template <class Work>
  void run_and_wait(const Work& work) {
    guarded(work);
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    if (first_) std::rethrow_exception(first_);
  }

 private:
  template <class Work>
  void guarded(const Work& work) {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!first_) first_ = std::current_exception();
    }
  }

  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::exception_ptr first_;
};

}  // namespace tbb
