#include "mpi/crew/task_board.h"

#include <algorithm>
#include <numeric>

#include "engine/base/error.h"

namespace af2::mpi {

std::uint64_t TaskBoard::begin(std::span<const double> work) {
  const std::lock_guard lock(mutex_);
  work_.assign(work.begin(), work.end());
  order_.resize(work.size());
  std::iota(order_.begin(), order_.end(), 0u);
  std::ranges::stable_sort(order_, [&](auto a, auto b) { return work_[a] > work_[b]; });
  next_ = 0;
  unfinished_ = work.size();
  workLeft_ = std::accumulate(work.begin(), work.end(), 0.0);
  return ++round_;
}

/// A third of what is left for each, so that the last tasks are small and all end together.
std::vector<std::size_t> TaskBoard::take(std::uint64_t round) {
  constexpr double kShare = 1.0 / 3;
  const std::lock_guard lock(mutex_);
  std::vector<std::size_t> tasks;
  if (round != round_ || !givenUp_.empty()) return tasks;
  const double share = kShare * workLeft_ / static_cast<double>(takers_);
  double sum = 0;
  while (next_ < order_.size() && (tasks.empty() || sum + work_[order_[next_]] <= share)) {
    tasks.push_back(order_[next_++]);
    sum += work_[tasks.back()];
  }
  workLeft_ -= sum;
  return tasks;
}

void TaskBoard::finish(std::size_t tasks) {
  const std::lock_guard lock(mutex_);
  unfinished_ -= tasks;
  if (unfinished_ == 0) finished_.notify_all();
}

void TaskBoard::wait() {
  std::unique_lock lock(mutex_);
  finished_.wait(lock, [&] { return unfinished_ == 0 || !givenUp_.empty(); });
  if (!givenUp_.empty()) throw InputError(givenUp_);
}

void TaskBoard::done() {
  const std::lock_guard lock(mutex_);
  ++done_;
  finished_.notify_all();
}

void TaskBoard::waitForDone(int count) {
  std::unique_lock lock(mutex_);
  finished_.wait(lock, [&] { return done_ >= count || !givenUp_.empty(); });
  if (!givenUp_.empty()) throw InputError(givenUp_);
  done_ -= count;
}

/// The first reason counts: others may follow from it.
void TaskBoard::giveUp(const std::string& reason) {
  const std::lock_guard lock(mutex_);
  if (givenUp_.empty()) givenUp_ = reason;
  finished_.notify_all();
}

}  // namespace af2::mpi
