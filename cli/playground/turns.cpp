#include "cli/playground/turns.h"

#include <condition_variable>

namespace af2::playground {

Turn::Turn(Turns& turns, const std::string& key, std::uint64_t number, std::chrono::seconds limit)
    : turns_(turns), key_(key), number_(number) {
  turns_.begin(*this);
  watch_ =
      std::jthread([this, limit](const std::stop_token& isOver) { waitForLimit(limit, isOver); });
}

Turn::~Turn() { turns_.finish(*this); }

void Turn::waitForLimit(std::chrono::seconds limit, const std::stop_token& isOver) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any().wait_for(lock, isOver, limit, [] { return false; });
  if (isOver.stop_requested() || stop_.stop_requested()) return;
  isLate_ = true;
  stop_.request_stop();
}

void Turns::begin(Turn& turn) {
  const std::lock_guard lock(mutex_);
  if (isOver_) turn.stop_.request_stop();
  Turn*& latest = latest_[turn.key_];
  if (latest && latest->number_ > turn.number_) {  // requests may arrive in another order
    turn.stop_.request_stop();
    return;
  }
  if (latest) latest->stop_.request_stop();
  latest = &turn;
}

void Turns::finish(Turn& turn) {
  const std::lock_guard lock(mutex_);
  const auto found = latest_.find(turn.key_);
  if (found != latest_.end() && found->second == &turn) latest_.erase(found);
}

void Turns::end() {
  const std::lock_guard lock(mutex_);
  isOver_ = true;
  for (const auto& [key, turn] : latest_) turn->stop_.request_stop();
}

}  // namespace af2::playground
