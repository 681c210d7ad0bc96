// One step of the advance on a piece of front in the plane, for rule authors and tests of rules.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "engine/rule/rule_set.h"
#include "engine/step/front_piece.h"
#include "engine/step/observer.h"

namespace af2 {

class CompiledRules;

/// The engine's result there.
struct SingleStep {
  /// Results of the applied rule; none if every rule is refused.
  std::optional<std::size_t> rule;
  double score = 0;
  std::vector<std::size_t> matched;  ///< vertex by pattern vertex
  std::vector<Point2> newVertices;   ///< numbered after the vertices of the piece
  std::vector<std::vector<std::size_t>> elements;
  /// Of a weld: the vertex that is gone, and the one that it has become.
  std::optional<std::pair<std::size_t, std::size_t>> welded;
  std::vector<std::pair<std::size_t, std::size_t>> frontAfter;
  /// For every rule that was not applied, why it was refused.
  std::vector<RuleRefusal> refusals;
};

/// Takes steps with one rule set, which is compiled only once. The rule set must outlive the
/// stepper.
///
/// All functions throw InputError if the piece is not a front: an index out of range, an edge of
/// length zero, the same edge twice, a base that is not an edge of a chain, a level or size out of
/// range.
class AF2_EXPORT SingleStepper {
 public:
  explicit SingleStepper(const RuleSet& rules);
  ~SingleStepper();

  /// Tries all rules of the set at the base edge of a piece of front.
  SingleStep take(const FrontPiece& piece) const;
  /// The rule that would be applied, none if every rule is refused; less than half the cost.
  std::optional<std::size_t> chosenRule(const FrontPiece& piece) const;
  /// Everything that hits the free zone of any match of any rule; a refusal names only the first.
  std::vector<RuleRefusal> obstacles(const FrontPiece& piece) const;

 private:
  const CompiledRules& compiledFor(const FrontPiece& piece) const;

  std::unique_ptr<const CompiledRules> compiled_;
};

/// One step with a temporary stepper.
AF2_EXPORT SingleStep takeSingleStep(const RuleSet& rules, const FrontPiece& piece);

}  // namespace af2
