// Random matches of a rule, for checks that arithmetic alone cannot decide.
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

/// Lengths of the base edges in samples and proofs, in multiples of the target size: the usual
/// lengths on a front. The limits are about 1/sqrt(2) and sqrt(2): an edge beyond them would be
/// closer to half or twice the target size.
inline constexpr double kShortestBase = 0.7, kLongestBase = 1.4;
/// The largest distance of a vertex from its reference if its tolerance sets no bound.
inline constexpr double kFarthestVertex = 2.5;

/// Draws matches of a rule at a level: the base edge has any of these lengths, or length 1 if the
/// chart is scaled to the base edge; every other vertex is anywhere within its tolerance.
class MatchSampler {
 public:
  MatchSampler(const RuleSet& rules, const AF2Rule& rule, int level, std::uint64_t seed = 1);

  /// A match that passes the level, the pattern and every `require`; nothing if many attempts find
  /// none.
  std::optional<PatternMatch> next();

  RandomNumbers& random() { return random_; }

 private:
  Point2 draw(const PatternVertex& vertex);
  Point2 drawNear(const NearPlace& near, std::vector<Point2> vertices);
  double drawBase();

  const RuleSet& rules_;
  const AF2Rule& rule_;
  int level_;
  double tolerance_;
  RandomNumbers random_;
};

/// The deviation of a match from the reference: the sum of squared deviations of its vertices.
double deviationOf(const PatternMatch& match);

}  // namespace af2::dsl
