// The conditions of `af2 compare --fail-if`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/compare/comparison.h"

namespace af2::cli {

/// "worse", "MEASURE worse", "MEASURE < NUMBER" or "MEASURE > NUMBER". A measure may begin with
/// "raw." or "finished."; without, it means finished meshes. "worse" alone means any measure of
/// either stage except time. A number is compared with the difference, second minus first.
struct FailCondition {
  enum class Kind { Worse, Below, Above };

  std::string text;     ///< as it was typed
  std::string measure;  ///< empty: any
  MeshStage stage = MeshStage::Finished;
  Kind kind = Kind::Worse;
  double bound = 0;
};

/// Throws UsageError, which says what can be written, if the text is no condition.
FailCondition parseFailCondition(const std::string& text);

/// What makes the condition hold, in one line; none if it does not hold. Where a measure has no
/// pairs of models, a condition on its difference does not hold.
std::optional<std::string> failureOf(const FailCondition& condition,
                                     const std::vector<MeasureComparison>& rows);

}  // namespace af2::cli
