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

/// Draws matches of a rule at a level: base edges of 0.7 to 1.4 times the wanted length, and each
/// other vertex anywhere within its tolerance.
class MatchSampler {
 public:
  MatchSampler(const RuleSet& rules, const AF2Rule& rule, int level, std::uint64_t seed = 1);

  /// A match that passes the pattern and every `require`; nothing if none is found in many tries.
  std::optional<PatternMatch> next();

  RandomNumbers& random() { return random_; }

 private:
  Point2 draw(const PatternVertex& vertex);

  const RuleSet& rules_;
  const AF2Rule& rule_;
  int level_;
  double tolerance_;
  RandomNumbers random_;
};

/// How far a match is from the reference: the sum of squared deviations.
double deviationOf(const PatternMatch& match);

}  // namespace af2::dsl
