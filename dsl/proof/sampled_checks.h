// Checks of rules over all matches that they accept, by proof or by random samples.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dsl/proof/proof.h"
#include "dsl/text/diagnostic.h"
#include "engine/base/export.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

struct SamplingOptions {
  int samples = 2000;     ///< matches that are tried for each rule and level
  int situations = 1000;  ///< pieces of front in which a rule may be chosen (D3)
  /// Only the errors: G2 and Z1 at the first level of each rule. All else are warnings.
  bool onlyErrors = false;
  std::uint64_t seed = 1;             ///< the same seed gives the same findings
  ProofEffort effort = kUsualEffort;  ///< for each rule, for G2 and for Z1
  /// Indices of rules that cannot be evaluated, see unknownRules(); they are skipped.
  std::set<std::size_t> unknown = {};
  std::function<bool()> isCancelled = {};  ///< called before each rule; true: skip the rest
};

/// A match that shows what is wrong: for a picture (drawMatch) and for a test.
struct CounterExample {
  std::vector<Point2> vertices;  ///< the matched ones in pattern order
  int level = 1;
  std::vector<Point2> marks;      ///< places at fault
  std::vector<Point2> obstacles;  ///< further vertices of the front
};

struct SampledFinding {
  /// The severity is the usual one of the code.
  explicit SampledFinding(Code what) : code(what), severity(infoOf(what).severity) {}

  Code code;
  Severity severity;
  std::size_t rule = 0;  ///< index in the rule set
  int element = -1;      ///< of the rule, where the finding is about one; of D1: the condition
  int zone = -1;         ///< of D1, where the condition is the `when` of a zone clause
  std::string message;   ///< the fault, one line without a full stop
  std::string help;
  CounterExample example;
  std::string test;  ///< a `test` block that shows the fault, ready to be put into the rule file
  std::vector<std::string> furtherTests;  ///< of N1
};

/// The number of levels, from a rule's first one on, at which its elements and zone are checked.
inline constexpr int kLevelsLookedAt = 20;

/// The certainty of an answer about all matches of a rule.
enum class Answer {
  Proven,    ///< holds for every match
  Sampled,   ///< no counter-example among the samples
  Refuted,   ///< there is a counter-example
  NotAsked,  ///< the rule need not have the property
};

struct RuleAnswers {
  /// G2: all elements are positive. Not asked where `accept` looks at the shape of each element.
  Answer positive = Answer::Sampled;
  Answer covered = Answer::Sampled;  ///< Z1: all elements lie in the free zone
  bool isTried = false;              ///< whether the levels of the rule set reach the rule
  double lostMatches =
      0;  ///< Z2: share of matches that are refused because the zone has no valid shape
};

struct SampledResult {
  std::vector<SampledFinding> findings;  ///< by rule, then by code
  std::vector<RuleAnswers> answers;      ///< by rule
};

/// G2 and Z1 at the first kLevelsLookedAt levels of each rule, Z2 at its own level, Z3, and D3.
/// Rules that the levels of the rule set never reach are skipped.
AF2_EXPORT SampledResult runSampledChecks(const RuleSet& rules,
                                          const SamplingOptions& options = {});

/// "12 rules; elements positive (G2): proven for 11, sampled for 1; inside the free zone (Z1): ..."
AF2_EXPORT std::string summaryOf(const SampledResult& result);

}  // namespace af2::dsl
