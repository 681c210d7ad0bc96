#include "cli/compare/comparison.h"

#include <gtest/gtest.h>

namespace af2::cli {
namespace {

CaseResult meshWith(double leastJacobian, std::size_t elements = 10) {
  CaseResult result;
  result.hasMesh = true;
  result.measures.quads = elements;
  result.measures.jacobian.min = leastJacobian;
  return result;
}

/// Finished meshes only; the raw ones are missing.
SuiteResult finished(const std::vector<std::pair<CaseResult, CaseResult>>& pairs) {
  SuiteResult result;
  for (const auto& [first, second] : pairs) {
    result.names.push_back("model");
    result.cases.push_back({{{CaseResult(), CaseResult()}, {first, second}}});
  }
  return result;
}

MeasureComparison rowOf(const SuiteResult& result, std::string_view name,
                        MeshStage stage = MeshStage::Finished) {
  for (const MeasureComparison& row : compare(result, false))
    if (row.name == name && row.stage == stage) return row;
  ADD_FAILURE() << "no row " << name;
  return {};
}

TEST(BootstrapMean, IsExactForEqualDifferences) {
  const std::vector<double> same(8, 0.25);
  const MeanInterval interval = bootstrapMean(same);
  EXPECT_EQ(interval.mean, 0.25);
  EXPECT_EQ(interval.low, 0.25);
  EXPECT_EQ(interval.high, 0.25);
}

TEST(BootstrapMean, HasAnIntervalAboutTwoStandardErrorsWide) {
  std::vector<double> values;
  for (int i = 0; i < 100; ++i) values.push_back(i % 2 == 0 ? 1 : -1);
  const MeanInterval interval = bootstrapMean(values);
  EXPECT_EQ(interval.mean, 0);
  EXPECT_NEAR(interval.low, -0.196, 0.03) << "1.96 times 1 / sqrt(100)";
  EXPECT_NEAR(interval.high, 0.196, 0.03);
}

TEST(BootstrapMean, IsTheSameEachTime) {
  const std::vector<double> values{1, 4, -2, 0.5, 3, 7};
  EXPECT_EQ(bootstrapMean(values).low, bootstrapMean(values).low);
}

TEST(Comparison, OfASetWithItselfShowsNoDifference) {
  std::vector<std::pair<CaseResult, CaseResult>> pairs;
  for (int i = 0; i < 8; ++i) pairs.emplace_back(meshWith(0.1 * i), meshWith(0.1 * i));
  for (const MeasureComparison& row : compare(finished(pairs), true)) {
    EXPECT_EQ(row.difference, 0) << row.name;
    EXPECT_TRUE(row.verdict == Verdict::NoDifference || row.verdict == Verdict::TooFew) << row.name;
  }
}

TEST(Comparison, PairsTheModels) {
  // Models differ by far more than the sets do; only the differences of pairs count.
  std::vector<std::pair<CaseResult, CaseResult>> pairs;
  for (int i = 0; i < 8; ++i) pairs.emplace_back(meshWith(0.1 * i), meshWith(0.1 * i + 0.01));
  const MeasureComparison row = rowOf(finished(pairs), "sj_min");
  EXPECT_NEAR(row.difference, 0.01, 1e-12);
  EXPECT_EQ(row.verdict, Verdict::Better);
}

TEST(Comparison, KnowsWhichDirectionIsWorse) {
  std::vector<std::pair<CaseResult, CaseResult>> pairs(8, {meshWith(0.5), meshWith(0.4, 20)});
  EXPECT_EQ(rowOf(finished(pairs), "sj_min").verdict, Verdict::Worse);
  EXPECT_EQ(rowOf(finished(pairs), "elements").verdict, Verdict::Different);
  for (auto& [first, second] : pairs) second.stuckFaces = 1;
  EXPECT_EQ(rowOf(finished(pairs), "stuck").verdict, Verdict::Worse);
}

TEST(Comparison, LeavesOutModelsWithoutMesh) {
  std::vector<std::pair<CaseResult, CaseResult>> pairs(8, {meshWith(0.5), meshWith(0.6)});
  pairs[0].second = CaseResult();
  pairs[0].second.failedFaces = 1;
  const MeasureComparison row = rowOf(finished(pairs), "sj_min");
  EXPECT_EQ(row.pairs, 7u);
  EXPECT_EQ(row.firstCount, 8u);
  EXPECT_EQ(rowOf(finished(pairs), "failed").pairs, 8u);
}

TEST(Comparison, ShowsWhatOneSetHasIfTheOtherHasNoMesh) {
  const std::vector<std::pair<CaseResult, CaseResult>> pairs(8, {CaseResult(), meshWith(0.6)});
  const MeasureComparison row = rowOf(finished(pairs), "sj_min");
  EXPECT_EQ(row.pairs, 0u);
  EXPECT_EQ(row.firstCount, 0u);
  EXPECT_NEAR(row.second, 0.6, 1e-12);
  EXPECT_EQ(row.verdict, Verdict::TooFew);
}

TEST(Comparison, SaysNothingAboutFiveModels) {
  const std::vector<std::pair<CaseResult, CaseResult>> pairs(5, {meshWith(0.5), meshWith(0.6)});
  EXPECT_EQ(rowOf(finished(pairs), "sj_min").verdict, Verdict::TooFew);
}

TEST(Comparison, HasTimesOnlyOnRequest) {
  const SuiteResult result = finished({{meshWith(0.5), meshWith(0.6)}});
  EXPECT_EQ(compare(result, true).size(), 2 * comparedMeasures().size());
  EXPECT_EQ(compare(result, false).size(), 2 * comparedMeasures().size() - 2);
}

}  // namespace
}  // namespace af2::cli
