// Runs code that may crash in a separate process first.
#pragma once

#include <chrono>
#include <functional>

namespace af2::geometry {

/// Whether `work` ends, by return or by exception, within `limit`. It runs in a forked copy of this
/// process, which may crash. On systems without fork it is not run, and the result is true.
///
/// OpenCASCADE's STEP translator dereferences entities that a damaged file refers to but does not
/// hold. Refusing all damaged files instead would refuse many that are harmless.
bool survives(const std::function<void()>& work, std::chrono::seconds limit);

}  // namespace af2::geometry
