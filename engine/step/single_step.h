// One step of the advance on a piece of front in the plane: for tests of rules and for their
// authors.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "engine/rule/rule_set.h"
#include "engine/step/observer.h"

namespace af2 {

class CompiledRules;

/// A piece of front in the plane. The unmeshed region lies to the left of each edge.
struct FrontPiece {
  std::vector<Point2> vertices;
  /// Chains of vertices joined by edges; one whose first vertex comes again at its end is closed.
  std::vector<std::vector<std::size_t>> chains;
  /// Vertices without an edge.
  std::vector<std::size_t> isolated;
  std::pair<std::size_t, std::size_t> base;  ///< an edge of a chain
  int level = 1;
  double size = 1;  ///< wanted edge length, in the units of the vertices
};

/// What the engine would do there.
struct SingleStep {
  /// Of the rule that was applied; none if every rule is refused.
  std::optional<std::size_t> rule;
  double score = 0;
  std::vector<std::size_t> matched;  ///< vertex by pattern vertex
  std::vector<Point2> newVertices;   ///< numbered on behind the vertices of the piece
  std::vector<std::vector<std::size_t>> elements;
  std::vector<std::pair<std::size_t, std::size_t>> frontAfter;
  /// For every rule but the applied one why it was refused.
  std::vector<RuleRefusal> refusals;
};

/// Takes steps with one rule set, which is made ready only once for each level. It must outlive the
/// stepper; one stepper serves one thread.
///
/// All throw InputError if the piece is no front: an index out of range, an edge of length zero,
/// the same edge twice, a base that is not among the edges, a level or size out of range.
class AF2_EXPORT SingleStepper {
 public:
  explicit SingleStepper(const RuleSet& rules);
  ~SingleStepper();

  /// Tries all rules of the set at the base edge of a piece of front.
  SingleStep take(const FrontPiece& piece);
  /// The rule that would be applied, none if every rule is refused; costs less than half as much.
  std::optional<std::size_t> chosenRule(const FrontPiece& piece);
  /// All that hits the free zone of any match of any rule; a refusal names the first only.
  std::vector<RuleRefusal> obstacles(const FrontPiece& piece);

 private:
  const CompiledRules& compiledFor(const FrontPiece& piece);

  const RuleSet& rules_;
  std::vector<std::unique_ptr<const CompiledRules>> byLevel_;  // [level - 1]; null until needed
};

/// One step with a stepper of its own.
AF2_EXPORT SingleStep takeSingleStep(const RuleSet& rules, const FrontPiece& piece);

}  // namespace af2
