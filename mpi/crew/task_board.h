// The tries of a round that nobody has begun, the largest first.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace af2::mpi {

/// Kept by the leader of a crew; may be used by several threads.
class TaskBoard {
 public:
  /// takers  how many threads of all processes take tasks
  explicit TaskBoard(std::size_t takers) : takers_(takers) {}

  /// work  by task. Returns the number of the round, which is never 0.
  std::uint64_t begin(std::span<const double> work);
  /// The next tasks: a single large one, or several small ones; none if all are taken, or if the
  /// round is over.
  std::vector<std::size_t> take(std::uint64_t round);
  void finish(std::size_t tasks);
  /// Waits until all tasks are finished. Throws InputError if somebody has given up.
  void wait();
  /// Somebody has done something else than a task.
  void done();
  /// Waits until that many more are done. Throws as `wait` does.
  void waitForDone(int count);
  /// No more tasks are taken.
  void giveUp(const std::string& reason);

 private:
  std::size_t takers_;
  std::mutex mutex_;
  std::condition_variable finished_;
  std::uint64_t round_ = 0;
  std::vector<double> work_;
  std::vector<std::size_t> order_;
  std::size_t next_ = 0, unfinished_ = 0;
  double workLeft_ = 0;
  int done_ = 0;
  std::string givenUp_;
};

}  // namespace af2::mpi
