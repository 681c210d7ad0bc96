#include "geometry/spool/spool_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <numeric>
#include <thread>
#include <vector>

#include "engine/base/error.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

namespace fs = std::filesystem;

class SpoolFiles : public ::testing::Test {
 protected:
  testing::TestFolder folder_;
};

std::vector<int> numbersFrom(int first, std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

SpoolFile::Place put(SpoolFile& file, const std::vector<int>& numbers) {
  const SpoolFile::Place place = file.reserve(numbers.size() * sizeof(int));
  file.write(place.begin, std::span(numbers));
  return place;
}

std::vector<int> at(const SpoolFile& file, const SpoolFile::Place& place) {
  std::vector<int> numbers(place.size / sizeof(int));
  file.read(place.begin, std::span(numbers));
  return numbers;
}

TEST_F(SpoolFiles, GiveBackWhatWasPutIntoThem) {
  SpoolFile file(folder_.path());
  const auto first = put(file, numbersFrom(0, 100'000)), second = put(file, numbersFrom(7, 3));
  const auto none = put(file, {});
  EXPECT_EQ(at(file, first), numbersFrom(0, 100'000));
  EXPECT_EQ(at(file, second), numbersFrom(7, 3));
  EXPECT_TRUE(at(file, none).empty());
}

TEST_F(SpoolFiles, TakeFromSeveralThreadsAtOnce) {
  SpoolFile file(folder_.path());
  std::vector<SpoolFile::Place> places(8);
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&, i] {
      for (int round = 0; round < 50; ++round)
        places[static_cast<std::size_t>(i)] = put(file, numbersFrom(1000 * i + round, 5000));
    });
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(at(file, places[static_cast<std::size_t>(i)]), numbersFrom(1000 * i + 49, 5000));
}

TEST_F(SpoolFiles, KeepTheOthersWhenRoomIsGivenBack) {
  SpoolFile file(folder_.path());
  const auto first = put(file, numbersFrom(0, 10'001)), second = put(file, numbersFrom(5, 10'001));
  file.release(first);
  EXPECT_EQ(at(file, second), numbersFrom(5, 10'001));
}

TEST_F(SpoolFiles, HaveNoNameThatCouldBeLeft) {
  SpoolFile file(folder_.path());
  put(file, numbersFrom(0, 1000));
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(SpoolFiles, SayWhichFolderHasNoPlaceForThem) {
  const fs::path missing = folder_ / "missing";
  try {
    SpoolFile file(missing);
    FAIL() << "it is kept nowhere";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(missing.string()), std::string::npos);
  }
}

TEST_F(SpoolFiles, DoNotGiveBackWhatWasNeverWritten) {
  SpoolFile file(folder_.path());
  const SpoolFile::Place place = file.reserve(1 << 20);
  EXPECT_THROW(at(file, place), InputError);
}

}  // namespace
}  // namespace af2::geometry
