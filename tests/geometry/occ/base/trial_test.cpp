// Work that may crash or hang, in forked processes.
#include "geometry/occ/base/trial.h"

#include <gtest/gtest.h>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace af2::geometry {
namespace {

TEST(Trial, GoesOnAfterWorkThatCrashesThrowsOrHangs) {
  const auto work = [](std::size_t i) -> std::string {
    if (i == 1) std::abort();
    if (i == 2) throw std::runtime_error("not this one");
    if (i == 4) std::this_thread::sleep_for(std::chrono::seconds(60));
    return std::string(i * 10000, 'x');
  };
  const auto results = resultsOf(6, work, {0.3, 30});
  ASSERT_EQ(results.size(), 6u);
  EXPECT_EQ(results[0], "");
  EXPECT_FALSE(results[1] || results[2] || results[4]);
  EXPECT_EQ(results[3]->size(), 30000u);
  EXPECT_EQ(results[5]->size(), 50000u);
}

}  // namespace
}  // namespace af2::geometry
