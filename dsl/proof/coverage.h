// N1: which situations of one, two and three front edges do the rules of a set accept, and at which
// level?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dsl/proof/sampled_checks.h"
#include "engine/base/export.h"
#include "engine/rule/rule_set.h"
#include "engine/step/single_step.h"

namespace af2::dsl {

/// A grid of situations.
struct CoverageMap {
  static constexpr int kNone = 0, kImpossible = -1;

  std::string title;           ///< "two edges"
  std::string xName, yName;    ///< yName is empty where there is one row only
  std::vector<double> xs, ys;  ///< lengths, or angles in degrees
  std::vector<int> levels;     ///< by row, then column: the lowest level at which a rule applies
  std::vector<FrontPiece> pieces;  ///< the situations themselves
  std::vector<bool> isOrdinary;    ///< see isOrdinary below

  int level(std::size_t x, std::size_t y) const { return levels[y * xs.size() + x]; }
};

struct Coverage {
  int lastLevel = 0;  ///< the highest level that was tried
  std::vector<CoverageMap> maps;
};

/// Tries the whole rule set on free-standing pieces of front: a single edge by its length; two
/// edges by the angle between them and the length of the second; three edges by their two angles.
/// Angles are those of the unmeshed side.
AF2_EXPORT Coverage measureCoverage(const RuleSet& rules, int lastLevel = 10);

/// Whether a front in good order comes to look like this: edges of 0.6 to 1.7 times the wanted
/// length, no free angle below 45 or above 315 degrees, and vertices that are not neighbours at
/// least half an edge apart.
AF2_EXPORT bool isOrdinary(const FrontPiece& piece);

/// A finding, about no rule in particular, if no rule accepts some ordinary situations. It has a
/// test for each kind of piece, on a situation amid those that are left out.
AF2_EXPORT std::optional<SampledFinding> findUncoveredSituations(const Coverage& coverage);

}  // namespace af2::dsl
