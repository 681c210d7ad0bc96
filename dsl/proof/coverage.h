// N1: which situations of one to three front edges do the rules accept, and at which level?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dsl/proof/closure.h"
#include "dsl/proof/sampled_checks.h"
#include "engine/base/export.h"
#include "engine/rule/rule_set.h"
#include "engine/step/single_step.h"

namespace af2::dsl {

/// A grid of situations.
struct CoverageMap {
  static constexpr int kNone = 0, kImpossible = -1;

  std::string title;           ///< "two edges"
  std::string xName, yName;    ///< yName is empty if there is only one row
  std::vector<double> xs, ys;  ///< lengths, or angles in degrees
  std::vector<int> levels;     ///< by row, then column: the lowest level at which a rule applies
  std::vector<FrontPiece> pieces;  ///< the situations themselves
  std::vector<bool> isOrdinary;    ///< see isOrdinary below
  /// Whether some rule is refused at the last level for its score alone: a more generous acceptance
  /// would let it be chosen.
  std::vector<bool> isRefusedByScore = {};

  int level(std::size_t x, std::size_t y) const { return levels[y * xs.size() + x]; }
};

struct Coverage {
  int lastLevel = 0;  ///< the highest level that was tried
  std::vector<CoverageMap> maps;
  std::optional<Closure> closure = {};  ///< of sets with `parity even`
};

/// Tries the whole rule set on isolated pieces of front: one edge, varied in length; two edges,
/// varied in their angle and the length of the second; three edges, varied in their two angles.
/// Angles are measured on the unmeshed side.
AF2_EXPORT Coverage measureCoverage(const RuleSet& rules, int lastLevel = 10);

/// Whether a situation is ordinary: edges of 0.6 to 1.7 times the target size, free angles of 45 to
/// 315 degrees, and a distance of at least half an edge between vertices that are not neighbours.
AF2_EXPORT bool isOrdinary(const FrontPiece& piece);

/// A finding, about no rule in particular, if no rule accepts some ordinary situations. It has a
/// test for each kind of piece, with a situation in the middle of the uncovered ones.
AF2_EXPORT std::optional<SampledFinding> findUncoveredSituations(const Coverage& coverage);

}  // namespace af2::dsl
