#include "cli/compare/fail_condition.h"

#include <gtest/gtest.h>

#include "cli/program/usage_error.h"

namespace af2::cli {
namespace {

MeasureComparison row(std::string_view name, MeshStage stage, double difference, Verdict verdict) {
  MeasureComparison result;
  result.name = name;
  result.stage = stage;
  result.pairs = 10;
  result.difference = difference;
  result.verdict = verdict;
  return result;
}

const std::vector<MeasureComparison> kRows{
    row("sj_min", MeshStage::Raw, -0.5, Verdict::Worse),
    row("sj_min", MeshStage::Finished, -0.01, Verdict::NoDifference),
    row("failed", MeshStage::Finished, 0.2, Verdict::NoDifference)};

bool holds(const std::string& text) {
  return failureOf(parseFailCondition(text), kRows).has_value();
}

TEST(FailCondition, ComparesTheDifferenceOfFinishedMeshes) {
  EXPECT_TRUE(holds("sj_min < 0"));
  EXPECT_FALSE(holds("sj_min < -0.02"));
  EXPECT_TRUE(holds("failed > 0"));
  EXPECT_TRUE(holds("finished.failed > 0.1"));
}

TEST(FailCondition, MayMeanRawMeshes) {
  EXPECT_TRUE(holds("raw.sj_min < -0.02"));
  EXPECT_TRUE(holds("raw.sj_min worse"));
  EXPECT_FALSE(holds("sj_min worse"));
}

TEST(FailCondition, WorseMeansAnyMeasure) {
  EXPECT_TRUE(holds("worse"));
  EXPECT_EQ(failureOf(parseFailCondition("worse"), kRows),
            "--fail-if \"worse\" holds: raw sj_min -0.5");
}

TEST(FailCondition, DoesNotGoByTimesUnlessTheyAreNamed) {
  const std::vector<MeasureComparison> rows{row("time", MeshStage::Raw, 5, Verdict::Worse)};
  EXPECT_FALSE(failureOf(parseFailCondition("worse"), rows));
  EXPECT_TRUE(failureOf(parseFailCondition("raw.time worse"), rows));
}

TEST(FailCondition, DoesNotHoldWithoutPairs) {
  std::vector<MeasureComparison> rows = kRows;
  for (MeasureComparison& one : rows) one.pairs = 0;
  EXPECT_FALSE(failureOf(parseFailCondition("sj_min < 1"), rows));
}

TEST(FailCondition, MustBeWrittenAsTold) {
  for (const char* const text :
       {"", "better", "sj_min", "sj_min <", "sj_min = 3", "sj_min < x", "sj_min < 1 2",
        "sj_mim < 1", "rough.sj_min < 1", "worse sj_min", "sj_min < nan"})
    EXPECT_THROW(parseFailCondition(text), UsageError) << text;
}

}  // namespace
}  // namespace af2::cli
