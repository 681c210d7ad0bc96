#include "geometry/sizes/too_many.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "geometry/base/free_memory.h"

namespace af2::geometry {
namespace {

std::string refusal(double elements, double maxMemory) {
  try {
    refuseTooMany(elements, maxMemory);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TooMany, IsWhatDoesNotFitTheMemory) {
  EXPECT_EQ(refusal(1e7, 2e9), "");
  EXPECT_EQ(refusal(4e7, 1e9),
            "the sizes need about 4e+07 elements, which take about 4 GB of memory, but 1 GB are "
            "allowed; ask for sizes that are at least 2 times as large");
}

TEST(TooMany, IsWhatCannotBeNumbered) {
  EXPECT_EQ(
      refusal(8e9, 1e15),
      "the sizes need about 8e+09 elements, but a mesh can have 2e+09; ask for sizes that are "
      "at least 2 times as large");
}

TEST(TooMany, IsNothingSmallUnlessTheUserAllowsLess) {
  EXPECT_EQ(refusal(1e5, 0), "");
  EXPECT_NE(refusal(1e5, 1e6), "");
}

TEST(FreeMemory, IsKnown) { EXPECT_GT(freeMemory(), 1e6); }

}  // namespace
}  // namespace af2::geometry
