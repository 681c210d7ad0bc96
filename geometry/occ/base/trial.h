// Runs code that may crash in a separate process first.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace af2::geometry {

/// Whether `work` ends, by return or by exception, within `limit`. It runs in a forked copy of this
/// process, which may crash. On systems without fork it is not run, and the result is true.
///
/// OpenCASCADE's STEP translator dereferences entities that a damaged file refers to but does not
/// hold. Refusing all damaged files instead would refuse many that are harmless.
bool survives(const std::function<void()>& work, std::chrono::seconds limit);

struct TrialLimits {
  double each = 10;  ///< seconds for one piece of work
  double all = 60;   ///< seconds for all of them
};

/// What work(0), work(1), ..., work(count - 1) return, computed in forked copies of this process.
/// There is no value for work that crashed, threw, or did not end within the limits. On systems
/// without fork it runs in this process, without limits.
std::vector<std::optional<std::string>> resultsOf(
    std::size_t count, const std::function<std::string(std::size_t)>& work,
    const TrialLimits& limits);

}  // namespace af2::geometry
