// Runs that a newer request of the same page overtakes, and that end after a limited time.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace af2::playground {

class Turns;

/// One run. It stops when a newer one with the same key begins, when its time is over, or when the
/// server ends.
class Turn {
 public:
  Turn(Turns& turns, const std::string& key, std::uint64_t number, std::chrono::seconds limit);
  ~Turn();
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  std::stop_token token() const { return stop_.get_token(); }
  /// A newer run has taken its place, so that nobody waits for the result.
  bool isOvertaken() const { return stop_.stop_requested() && !isLate_; }
  bool isLate() const { return isLate_; }

 private:
  friend class Turns;
  void waitForLimit(std::chrono::seconds limit, const std::stop_token& isOver);

  Turns& turns_;
  std::string key_;
  std::uint64_t number_;
  std::stop_source stop_;
  std::atomic<bool> isLate_ = false;
  std::jthread watch_;
};

class Turns {
 public:
  /// All runs stop, and those that begin later.
  void end();

 private:
  friend class Turn;
  void begin(Turn& turn);
  void finish(Turn& turn);

  std::mutex mutex_;
  std::map<std::string, Turn*> latest_;  ///< by key; those that are under way
  bool isOver_ = false;
};

}  // namespace af2::playground
