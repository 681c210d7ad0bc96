// Ctrl-C and SIGTERM as a request to stop.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <stop_token>
#include <thread>

namespace af2::cli {

/// Signals within this time are copies of one request.
inline constexpr std::chrono::milliseconds kSameRequest(500);

/// Tells requests to stop from copies of the first one.
class StopRequests {
 public:
  /// Whether it is another request than the first.
  bool addAndTestAgain() {
    const Clock::time_point now = Clock::now();
    if (!first_) first_ = now;
    return now - *first_ > kSameRequest;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> first_;
};

/// During its lifetime, the first SIGINT or SIGTERM requests a stop; a later one ends the program
/// at once. Programs that signal a whole process group, such as `timeout` and batch systems,
/// deliver some signals more than once; therefore all signals within half a second count as one,
/// and after a request to stop both signals stay blocked, so that a late one does not change the
/// exit code. Construct it before other threads start, so that they inherit the blocked signals.
///
/// A thread waits for the signals from the first token on. Until then they are kept: what a program
/// does alone is faster (reference_counts.cpp).
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token();
  bool requested() const { return stop_.stop_requested(); }

 private:
  void waitForSignals();
  void takeKept();

  std::stop_source stop_;
  std::atomic<bool> over_ = false;
  std::thread waiting_;
};

}  // namespace af2::cli
