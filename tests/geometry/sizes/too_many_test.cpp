#include "geometry/sizes/too_many.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/base/error.h"
#include "geometry/base/free_memory.h"

namespace af2::geometry {
namespace {

std::string refusal(double elements, double maxMemory) {
  try {
    refuseTooMany({elements}, {maxMemory});
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

TEST(TooMany, CountsOnlyTheLargestFacesIfTheOthersAreOnDisk) {
  const std::vector<double> elements{1e7, 3e7, 2e7, 4e7};
  EXPECT_NO_THROW(refuseTooMany(elements, {4.5e9, true, 1}));  // 4 GB, and 4 bytes of each
  EXPECT_THROW(refuseTooMany(elements, {4.3e9, true, 1}), TooManyElements);
  EXPECT_NO_THROW(refuseTooMany(elements, {7.5e9, true, 2}));  // the two largest are in work
  EXPECT_THROW(refuseTooMany(elements, {7.3e9, true, 2}), TooManyElements);
  EXPECT_THROW(refuseTooMany(elements, {7.5e9, false, 2}), TooManyElements);
}

TEST(TooMany, IsWhatDoesNotFitOnTheDisk) {
  const auto onDisk = [](double bytes, bool isSpooled) {
    try {
      refuseTooMany({2e7, 2e7}, {1e10, isSpooled, 1, bytes});
    } catch (const TooManyElements& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(onDisk(2.1e9, true), "");
  EXPECT_EQ(
      onDisk(3.5e8, true),
      "the sizes need about 4e+07 elements, whose faces take at least 1.4 GB of the disk that "
      "the mesh is written to, but 0.35 GB are free there; write to a larger disk, or ask for "
      "sizes that are at least 2 times as large");
  EXPECT_EQ(onDisk(3.5e8, false), "");
}

TEST(TooMany, TellsIfItFitsWithFacesOnDisk) {
  const auto fitSpooled = [](const std::vector<double>& elements, const MemoryLimit& limit) {
    try {
      refuseTooMany(elements, limit);
    } catch (const TooManyElements& error) {
      return std::string(error.what()).find("(--stream)") != std::string::npos &&
             error.fitSpooled();
    }
    return false;
  };
  EXPECT_TRUE(fitSpooled({1e7, 1e7, 1e7}, {2e9, false, 1}));
  EXPECT_FALSE(fitSpooled({1e7, 1e7, 1e7}, {2e9, false, 2}));
  EXPECT_FALSE(fitSpooled({3e7}, {2e9, false, 1}));
}

/// Finished faces take 18 bytes for each element there, and 4 more for the checks.
TEST(TooMany, IsWhatDoesNotFitIntoMemoryPacked) {
  const std::vector<double> elements(10, 1e7);
  const auto packedIn = [](double bytes) {
    MemoryLimit limit{bytes, true, 1};
    limit.isPacked = true;
    return limit;
  };
  EXPECT_NO_THROW(refuseTooMany(elements, packedIn(3.3e9)));
  try {
    refuseTooMany(elements, packedIn(3.1e9));
    FAIL() << "accepted";
  } catch (const TooManyElements& error) {
    EXPECT_TRUE(error.fitSpooled());
    EXPECT_NE(std::string(error.what()).find("about 3.2 GB of memory"), std::string::npos)
        << error.what();
  }
}

TEST(TooMany, IsNothingSmallUnlessTheUserAllowsLess) {
  EXPECT_EQ(refusal(1e5, 0), "");
  EXPECT_NE(refusal(1e5, 1e6), "");
}

TEST(FreeMemory, IsKnown) { EXPECT_GT(freeMemory(), 1e6); }

}  // namespace
}  // namespace af2::geometry
