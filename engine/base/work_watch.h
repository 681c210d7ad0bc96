// Asks long loops to stop, and learns from them that the work goes on.
// Not installed.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <utility>

namespace af2 {

/// Of one thread.
class WorkWatch {
 public:
  /// goesOn  called at some of the turns of the loops; may be empty
  WorkWatch(std::stop_token stop = {}, std::function<void()> goesOn = {})
      : stop_(std::move(stop)), goesOn_(std::move(goesOn)) {}

  /// To be called at each turn of a loop that can take long.
  bool mustStop() const {
    constexpr unsigned kTurns = 64;  // a turn takes a millisecond at most
    if (++turns_ % kTurns == 0 && goesOn_) goesOn_();
    return stop_.stop_requested();
  }
  /// The same for loops whose turns are short, numbered from 0.
  bool mustStopAt(std::size_t turn) const {
    constexpr std::size_t kShortTurns = 256;
    return turn % kShortTurns == 0 && mustStop();
  }

 private:
  std::stop_token stop_;
  std::function<void()> goesOn_;
  mutable unsigned turns_ = 0;
};

}  // namespace af2
