// Runs many independent tasks on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace af2::geometry {

/// Calls `work`, whose parallel parts use at most `threads` threads (0: as many as the caller's TBB
/// arena has). Exceptions are passed on.
void withThreads(int threads, const std::function<void()>& work);

/// How many threads run what `threads` asks for here.
int threadCount(int threads);

/// Calls work(0), ..., work(count - 1), each once, started in this order, on up to `threads`
/// threads (0: as many as the caller's TBB arena has). The first exception stops the remaining
/// calls and is passed on.
void forEachInParallel(std::size_t count, int threads,
                       const std::function<void(std::size_t)>& work);

}  // namespace af2::geometry
