// Runs work in a separate process, so that a crash or an endless loop does not lose the result.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "engine/base/error.h"

namespace af2::cli {

/// Receives the progress of a supervised run, from any of its threads.
class RunLog {
 public:
  virtual ~RunLog() = default;
  virtual void begin(int face) = 0;  ///< this thread starts on a face
  virtual void finish() = 0;         ///< this thread is done with its face
  virtual void beat() = 0;           ///< this thread has made progress
};

/// By face: why it is not tried again.
using GivenUp = std::map<int, std::string>;

/// Limits in processor seconds.
struct RunLimits {
  double first = 30;  ///< until the run begins its first face
  /// While it works on a face: until its next sign of progress. Halved after each hang, down to an
  /// eighth, so that a run with many such faces ends, too.
  double next = 20;
};

/// For `RunLimits::first`: large models take long to read.
inline double secondsToRead(std::uintmax_t bytes) {
  constexpr double kMin = 30, kPerByte = 2e-6;
  return kMin + kPerByte * static_cast<double>(bytes);
}

/// A run that crashed or hung outside any face, so that leaving out faces cannot help.
struct RunEnded : InputError {
  /// cause  such as "the run crashed (Segmentation fault)"
  explicit RunEnded(const std::string& how)
      : InputError("the model cannot be used: " + how +
                   " before it began to mesh a face; export the model again"),
        cause(how) {}
  std::string cause;
};

/// Runs `run` in a child process. If that crashes or hangs while it works on a face, runs it again
/// without this face. Interrupts and requests to stop are passed on.
///
/// Returns what `run` returns. It returns in the child process, too, which continues as if it were
/// the whole program. Costs one fork, and memory only for what the child changes.
///
/// Throws RunEnded if the child crashes outside any face, or hangs before the first one.
int supervise(RunLimits limits, const std::function<int(RunLog&, const GivenUp&)>& run);

}  // namespace af2::cli
