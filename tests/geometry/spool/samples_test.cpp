#include "geometry/spool/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace af2::geometry {
namespace {

std::vector<double> randomNumbers(std::size_t count, double step) {
  std::mt19937 random(7);
  std::vector<double> numbers(count);
  std::normal_distribution<double> any(1, 0.3);
  for (double& number : numbers) {
    number = any(random);
    if (step > 0) number = step * std::round(number / step);
  }
  return numbers;
}

void expectSame(const std::vector<double>& numbers) {
  Samples inMemory, onDisk(std::make_shared<SpoolFile>(::testing::TempDir()));
  for (const double number : numbers) {
    inMemory.add(number);
    onDisk.add(number);
  }
  ASSERT_EQ(onDisk.count(), numbers.size());
  EXPECT_NEAR(onDisk.mean(), inMemory.mean(), 1e-12);
  for (const double part : {0.0, 0.01, 0.05, 0.5, 0.777, 0.95, 1.0})
    EXPECT_EQ(onDisk.percentile(part), inMemory.percentile(part)) << part;
}

TEST(Samples, HaveTheSamePercentilesOnDisk) { expectSame(randomNumbers(1'000'003, 0)); }

TEST(Samples, HaveTheSamePercentilesWhereManyAreEqual) {
  expectSame(randomNumbers(1'000'003, 0.5));
  expectSame(std::vector<double>(700'000, 2.5));
}

TEST(Samples, AreInMemoryWhileTheyAreFew) { expectSame(randomNumbers(100, 0)); }

TEST(Samples, HaveNoPercentileIfThereAreNone) {
  Samples none;
  EXPECT_EQ(none.count(), 0u);
  EXPECT_EQ(none.percentile(0.5), 0);
}

}  // namespace
}  // namespace af2::geometry
