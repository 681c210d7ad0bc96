// Ctrl-C and SIGTERM as a request to stop.
#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace af2::cli {

/// While it lives, the first SIGINT or SIGTERM requests a stop; a later one ends the program at
/// once. Whoever signals a whole group of processes, as `timeout` and batch systems do, sends some
/// of them more than one; so those within half a second count as one. Make it before other threads
/// start: they inherit that these signals are not theirs.
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
