// Ctrl-C and SIGTERM as a request to stop.
#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace af2::cli {

/// While it lives, the first SIGINT or SIGTERM requests a stop; the second one ends the program at
/// once. Make it before other threads start: they inherit that these signals are not theirs.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return stop_.get_token(); }
  bool requested() const { return stop_.stop_requested(); }

 private:
  void waitForSignals();

  std::stop_source stop_;
  std::atomic<bool> over_ = false;
  std::thread waiting_;
};

}  // namespace af2::cli
