// Seconds that have passed, for reports only: nothing that a mesh depends on may look at a clock.
#pragma once

#include <chrono>

namespace af2 {

/// Runs from when it is made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace af2
