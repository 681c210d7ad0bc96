// Trying out in a process of its own what may crash this one.
#pragma once

#include <chrono>
#include <functional>

namespace af2::geometry {

/// Whether `work` comes back, by return or by exception, within `limit`: it runs in a forked copy
/// of this process, which may crash. Where there is no fork, it is not tried and counts as
/// surviving.
///
/// OpenCASCADE's STEP translator dereferences entities that a damaged file refers to but does not
/// hold. Refusing all damaged files instead would refuse many that are harmless.
bool survives(const std::function<void()>& work, std::chrono::seconds limit);

}  // namespace af2::geometry
