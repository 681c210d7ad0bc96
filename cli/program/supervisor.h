// A run in a process of its own, so that neither a crash nor an endless loop takes the result down.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "engine/base/error.h"

namespace af2::cli {

/// What a supervised run tells of itself, from any of its threads.
class RunLog {
 public:
  virtual ~RunLog() = default;
  virtual void begin(int face) = 0;  ///< this thread now works on a face
  virtual void finish() = 0;         ///< this thread is done with its face
  virtual void beat() = 0;           ///< this thread is getting on
};

/// By face: why it is not tried.
using GivenUp = std::map<int, std::string>;

/// Processor seconds.
struct RunLimits {
  double first = 30;  ///< until the run begins its first face
  double next = 20;   ///< until it tells of anything again, while it works on a face; half of it
                      ///< after each hang, down to an eighth: many such faces end, too
};

/// For `RunLimits::first`: large models take long to read.
inline double secondsToRead(std::uintmax_t bytes) {
  constexpr double kLeast = 30, kPerByte = 2e-6;
  return kLeast + kPerByte * static_cast<double>(bytes);
}

/// A run that cannot be repeated without what took it down.
struct RunEnded : InputError {
  /// cause  such as "it ended in a crash (Segmentation fault)"
  explicit RunEnded(const std::string& how)
      : InputError("the model cannot be used: " + how +
                   " before any face was begun; export the model again"),
        cause(how) {}
  std::string cause;
};

/// Runs `run` in a child process. If that crashes or hangs while it works on a face, runs it again
/// without this face. Interrupts and requests to stop are passed on.
///
/// Returns what `run` returns; in the child process, too, which goes on from there as if it were
/// the whole program. Costs one fork, and memory for nothing but what the child changes.
///
/// Throws RunEnded if the child crashes while it works on no face, or hangs before the first one.
int supervise(RunLimits limits, const std::function<int(RunLog&, const GivenUp&)>& run);

}  // namespace af2::cli
