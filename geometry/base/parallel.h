// Doing many independent things with several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace af2::geometry {

/// Calls `work`; what it does in parallel happens on up to `threads` threads (0: as many as the
/// caller's TBB arena has). Exceptions are thrown on.
void withThreads(int threads, const std::function<void()>& work);

/// Calls work(0), ..., work(count - 1), each once, started in this order, on up to `threads`
/// threads (0: as many as the caller's TBB arena has). The first exception stops the rest and is
/// thrown on.
void forEachInParallel(std::size_t count, int threads,
                       const std::function<void(std::size_t)>& work);

}  // namespace af2::geometry
