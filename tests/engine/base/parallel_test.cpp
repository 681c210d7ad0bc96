#include "engine/base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

namespace af2 {
namespace {

TEST(Ranges, HoldEachNumberOnceInOrder) {
  for (const std::size_t count : {0u, 1u, 9u, 10u, 11u, 30u}) {
    const Ranges ranges(count, 10);
    std::size_t next = 0;
    for (std::size_t i = 0; i < ranges.count(); ++i) {
      EXPECT_FALSE(ranges[i].empty());
      for (const std::size_t number : ranges[i]) EXPECT_EQ(number, next++);
    }
    EXPECT_EQ(next, count);
  }
}

TEST(ForEachInParallel, CallsTheWorkOnceForEachOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7})
    for (const std::size_t count : {0u, 1u, 2u, 100u}) {
      std::vector<std::atomic<int>> calls(count);
      forEachInParallel(count, threads, [&](std::size_t i) { ++calls[i]; });
      for (const auto& all : calls) EXPECT_EQ(all, 1);
    }
}

TEST(ForEachInParallel, PassesErrorsOn) {
  const auto fail = [](std::size_t i) {
    if (i == 3) throw std::runtime_error("three");
  };
  for (const int threads : {1, 2})
    EXPECT_THROW(forEachInParallel(9, threads, fail), std::runtime_error);
  EXPECT_THROW(
      forEachInParallel(1, 2, [](std::size_t) { throw std::runtime_error("the only one"); }),
      std::runtime_error);
}

/// What is done for one face must not be half done because another one fails at the same time.
TEST(ForEachInParallel, MakesAllCallsWithinOthersOfWhichOneFails) {
  for (int turn = 0; turn < 20; ++turn) {
    std::atomic<bool> isInside = false, hasFailed = false;
    std::atomic<int> calls = 0;
    const auto work = [&](std::size_t i) {
      if (i == 0) {
        while (!isInside) std::this_thread::yield();
        hasFailed = true;
        throw std::runtime_error("one failed");
      }
      isInside = true;
      while (!hasFailed) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));  // until the other one has thrown
      forEachInParallel(100, 0, [&](std::size_t) { ++calls; });
    };
    EXPECT_THROW(withThreads(2, [&] { forEachInParallel(2, 0, work); }), std::runtime_error);
    EXPECT_EQ(calls, 100);
  }
}

TEST(WithThreads, HoldsForWhatTheWorkDoesInParallel) {
  const auto threadsOf = [](std::size_t count) {
    std::mutex mutex;
    std::set<std::thread::id> threads;
    forEachInParallel(count, 0, [&](std::size_t) {
      const std::lock_guard lock(mutex);
      threads.insert(std::this_thread::get_id());
    });
    return threads.size();
  };
  const int before = threadCount(0);
  withThreads(1, [&] {
    EXPECT_EQ(threadCount(0), 1);
    EXPECT_EQ(threadsOf(1000), 1u);
    withThreads(2, [&] { EXPECT_EQ(threadCount(0), std::min(2, before)); });
    EXPECT_EQ(threadCount(0), 1);
  });
  forEachInParallel(2, 2,
                    [&](std::size_t) { withThreads(1, [&] { EXPECT_EQ(threadsOf(1000), 1u); }); });
  EXPECT_THROW(withThreads(1, [] { throw std::runtime_error("alone"); }), std::runtime_error);
  EXPECT_EQ(threadCount(0), before);
}

TEST(TakeInOrder, TakesWhatIsMadeInOrder) {
  for (const int threads : {1, 2})
    for (const std::size_t count : {0u, 1u, 5u, 100u}) {
      std::vector<std::size_t> taken;
      takeInOrder(
          count, threads, [](std::size_t i) { return i * i; },
          [&](std::size_t square) { taken.push_back(square); });
      ASSERT_EQ(taken.size(), count);
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(taken[i], i * i);
    }
}

}  // namespace
}  // namespace af2
