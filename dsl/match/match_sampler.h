// Random matches of a rule, for checks that cannot be decided by arithmetic alone.
#pragma once

#include <cstdint>
#include <optional>

#include "dsl/match/pattern_match.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

/// Random numbers that are the same on every platform. Source: [Steele14], splitmix64.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}
  /// In [0, 1).
  double unit();
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Uniform in the unit disc.
  Point2 inDisc();

 private:
  std::uint64_t state_;
};

/// Lengths of the base edges that samples and proofs look at, in wanted lengths: what a front has
/// where sizes are kept. An edge that is more than a square root of two too long or too short would
/// be closer to the next size.
inline constexpr double kShortestBase = 0.7, kLongestBase = 1.4;
/// How far a vertex may be from its reference where its tolerance sets no bound.
inline constexpr double kFarthestVertex = 2.5;

/// Draws matches of a rule at a level: base edges of any of these lengths, or of length 1 where the
/// chart is scaled to the base; and each other vertex anywhere within its tolerance.
class MatchSampler {
 public:
  MatchSampler(const RuleSet& rules, const AF2Rule& rule, int level, std::uint64_t seed = 1);

  /// A match that passes level, pattern and every `require`; nothing if none is found in many
  /// tries.
  std::optional<PatternMatch> next();

  RandomNumbers& random() { return random_; }

 private:
  Point2 draw(const PatternVertex& vertex);
  double drawBase();

  const RuleSet& rules_;
  const AF2Rule& rule_;
  int level_;
  double tolerance_;
  RandomNumbers random_;
};

/// How far a match is from the reference: the sum of squared deviations.
double deviationOf(const PatternMatch& match);

}  // namespace af2::dsl
