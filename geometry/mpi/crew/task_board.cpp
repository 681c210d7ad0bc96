#include "geometry/mpi/crew/task_board.h"

#include <algorithm>
#include <numeric>

#include "engine/base/error.h"

namespace af2::mpi {

namespace {

std::vector<std::size_t> mostWorkFirst(std::span<const double> work) {
  std::vector<std::size_t> order(work.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, [&](auto a, auto b) { return work[a] > work[b]; });
  return order;
}

}  // namespace

std::uint64_t TaskBoard::begin(std::span<const geometry::FaceTry> tries,
                               std::span<const double> work) {
  const std::lock_guard lock(mutex_);
  tries_.assign(tries.begin(), tries.end());
  work_.assign(work.begin(), work.end());
  order_ = mostWorkFirst(work);
  next_ = 0;
  unfinished_ = tries.size();
  workLeft_ = std::accumulate(work.begin(), work.end(), 0.0);
  regions_.clear();
  return ++round_;
}

std::optional<Task> TaskBoard::takeIfAny(std::uint64_t round) {
  const std::lock_guard lock(mutex_);
  if (round != round_ || unfinished_ == 0 || !givenUp_.empty()) return Task{};
  if (next_ < order_.size()) return nextTries();
  return nextHelp();
}

/// Of what is left, a third for each, so that the last tasks are small and all end together.
Task TaskBoard::nextTries() {
  constexpr double kShare = 1.0 / 3;
  const double share = kShare * workLeft_ / static_cast<double>(takers_);
  Task task{TaskKind::Mesh, {}, 0};
  double sum = 0;
  while (next_ < order_.size() && (task.tries.empty() || sum + work_[order_[next_]] <= share)) {
    const std::size_t k = order_[next_++];
    task.tries.push_back({k, tries_[k]});
    sum += work_[k];
  }
  workLeft_ -= sum;
  return task;
}

/// Where most pieces are left. No more threads are sent to a face than there are pieces.
std::optional<Task> TaskBoard::nextHelp() {
  Region* best = nullptr;
  const auto left = [](const Region& r) { return r.order.size() - r.next; };
  for (auto& [number, region] : regions_)
    if (left(region) > region.invited && (!best || left(region) > left(*best))) best = &region;
  if (!best) return std::nullopt;
  ++best->invited;
  return Task{TaskKind::Help, {{best->key.number, tries_[best->key.number]}}, best->owner};
}

Task TaskBoard::take(std::uint64_t round) {
  while (true) {
    std::unique_lock lock(mutex_);
    const std::size_t before = changes_;
    lock.unlock();
    if (std::optional<Task> task = takeIfAny(round)) return *std::move(task);
    lock.lock();
    changed_.wait(lock, [&] { return changes_ != before; });
  }
}

void TaskBoard::finish(std::size_t tries) {
  const std::lock_guard lock(mutex_);
  unfinished_ -= tries;
  change();
}

void TaskBoard::offer(const RegionKey& key, int owner, std::span<const double> work) {
  const std::lock_guard lock(mutex_);
  if (key.round != round_) return;
  regions_[key.number] = {key, owner, mostWorkFirst(work), 0, 0};
  change();
}

std::optional<std::size_t> TaskBoard::nextPiece(const RegionKey& key, bool isInvited) {
  const std::lock_guard lock(mutex_);
  const auto found = regions_.find(key.number);
  if (found == regions_.end() || found->second.key != key || !givenUp_.empty()) return std::nullopt;
  Region& region = found->second;
  if (isInvited && region.invited > 0) --region.invited;
  if (region.next == region.order.size()) return std::nullopt;
  return region.order[region.next++];
}

void TaskBoard::done() {
  const std::lock_guard lock(mutex_);
  ++done_;
  change();
}

void TaskBoard::waitForDone(int count) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return done_ >= count || !givenUp_.empty(); });
  if (!givenUp_.empty()) throw InputError(givenUp_);
  done_ -= count;
}

/// The first reason counts: others may follow from it.
void TaskBoard::giveUp(const std::string& reason) {
  const std::lock_guard lock(mutex_);
  if (givenUp_.empty()) givenUp_ = reason;
  change();
}

void TaskBoard::check() {
  const std::lock_guard lock(mutex_);
  if (!givenUp_.empty()) throw InputError(givenUp_);
}

void TaskBoard::change() {
  ++changes_;
  changed_.notify_all();
}

}  // namespace af2::mpi
