// What a match of a rule would make, and its score. Does not look at free zones.
#pragma once

#include <span>
#include <vector>

#include "engine/front/front_index.h"
#include "engine/step/compiled_rules.h"
#include "engine/step/observer.h"
#include "engine/step/rule_matcher.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// A match that is accepted if its free zone is empty.
struct Candidate {
  double score = 0;
  const CompiledRule* rule = nullptr;
  Match match;  ///< with the positions of the new vertices after those of the matched ones

  std::span<const Point2> matchedPoints() const {
    return {match.points.data(), static_cast<std::size_t>(rule->matchedCount)};
  }
};

class CandidateScorer {
 public:
  /// Keeps references to all arguments.
  CandidateScorer(const CompiledRules& rules, const FrontIndex& index, const SizeField& size,
                  const std::vector<std::uint8_t>& valence)
      : rules_(rules), index_(index), size_(size), valence_(valence) {}

  /// Places the new vertices and scores the candidate, or returns why it is refused.
  Refusal evaluate(const StepView& view, Candidate& candidate) const;

 private:
  Refusal evaluateOpenly(const StepView& view, Candidate& candidate) const;
  Refusal scoreElements(const StepView& view, Candidate& candidate) const;
  Refusal judge(const StepView& view, const Candidate& candidate) const;

  const CompiledRules& rules_;
  const FrontIndex& index_;
  const SizeField& size_;
  const std::vector<std::uint8_t>& valence_;
};

}  // namespace af2
