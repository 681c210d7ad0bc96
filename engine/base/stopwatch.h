// Elapsed seconds, for reports only: a mesh must not depend on a clock.
#pragma once

#include <chrono>

namespace af2 {

/// Starts when it is constructed.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace af2
