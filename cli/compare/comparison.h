// What two rule sets differ in: measures of their meshes, paired by model.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/compare/suite_run.h"

namespace af2::cli {

/// Which values of a measure are good.
enum class Better { Higher, Lower, Neither };

struct ComparedMeasure {
  std::string_view name;  ///< as in --fail-if
  std::string_view meaning;
  Better better = Better::Lower;
  /// None if the measure needs a mesh and there is none, or if the mesh has no such thing.
  std::optional<double> (*of)(const CaseResult&) = nullptr;
  bool isTime = false;
};

/// In the order of the table.
std::span<const ComparedMeasure> comparedMeasures();

enum class Verdict { Better, Worse, Different, NoDifference, TooFew };
const char* toString(Verdict verdict);

/// Fewer pairs say nothing: five out of five agree by chance in one of sixteen cases.
inline constexpr std::size_t kFewestPairs = 6;

/// One measure over all models on which both rule sets have it.
struct MeasureComparison {
  std::string_view name;
  MeshStage stage = MeshStage::Raw;
  std::size_t pairs = 0;
  double first = 0, second = 0;  ///< means over the pairs; if there are none, over each set alone
  std::size_t firstCount = 0, secondCount = 0;  ///< models on which each set has it
  double difference = 0;                        ///< second - first
  double low = 0, high = 0;                     ///< 95 % interval of the mean difference
  Verdict verdict = Verdict::TooFew;            ///< on the second set
};

/// The mean of paired differences, and the interval in which 95 % of the means of resampled pairs
/// lie (percentile bootstrap with a fixed seed: the same differences give the same interval).
struct MeanInterval {
  double mean = 0, low = 0, high = 0;
};
MeanInterval bootstrapMean(std::span<const double> differences);

/// All measures of both stages; those of time only if `withTime`.
std::vector<MeasureComparison> compare(const SuiteResult& result, bool withTime);

}  // namespace af2::cli
