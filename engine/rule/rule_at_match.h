// What a rule alone determines at a match: whether the pattern fits, whether its conditions hold,
// where its new vertices go.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/base/export.h"
#include "engine/rule/binding.h"
#include "engine/rule/refusal.h"
#include "engine/rule/rule.h"

namespace af2 {

/// A reason for a refusal, with the numbers that led to it.
struct RefusalCause {
  Refusal reason = Refusal::None;
  /// Index in the rule's list of pattern vertices or edges, conditions, new vertices or elements;
  /// -1 where the reason is not about one of them.
  int index = -1;
  bool isEdge = false;          ///< Pattern: `index` is that of a pattern edge, whose slope misfits
  double value = 0, limit = 0;  ///< Pattern: the tolerance form and the largest allowed value

  bool isNone() const { return reason == Refusal::None; }
};

/// Pattern if a vertex or a slope deviates by more than the tolerance, else None.
///
/// binding    the ends of the base edge are not tested
/// tolerance  largest allowed value of a tolerance form at the level
AF2_EXPORT RefusalCause patternMisfit(const RuleDefinition& rule, const AF2Binding& binding,
                                      double tolerance);

/// Require or NoValue for the first condition that does not hold, else None.
AF2_EXPORT RefusalCause failedRequirement(const RuleDefinition& rule, const AF2Binding& binding);

/// The position of one of the new vertices; no value where it is not finite.
AF2_EXPORT std::optional<Point2> newVertexAt(const RuleDefinition& rule, std::size_t index,
                                             const AF2Binding& binding);
AF2_EXPORT std::vector<std::optional<Point2>> newVerticesAt(const RuleDefinition& rule,
                                                            const AF2Binding& binding);

/// What the rule adds to its score, 0 for most rules; no value where it is not finite.
AF2_EXPORT std::optional<double> costAt(const RuleDefinition& rule, const AF2Binding& binding);

/// A rule at given positions of its pattern. The front consists only of the pattern's edges and
/// isolated vertices; the size field is uniform, the surface is a plane.
class AF2_EXPORT RuleAtMatch : public AF2Surroundings {
 public:
  /// vertices  the matched ones in pattern order; [0] and [1] on the x axis
  /// Keeps a reference to `rule`.
  RuleAtMatch(const RuleDefinition& rule, std::vector<Point2> vertices, int level);
  /// The reference positions of the pattern's vertices.
  static RuleAtMatch atReference(const RuleDefinition& rule, int level);

  const std::vector<Point2>& vertices() const { return vertices_; }
  int level() const { return level_; }
  AF2Binding binding() const { return {vertices_, level_, this}; }
  /// Matched and new vertices; no value where a new one has no position.
  std::optional<std::vector<Point2>> placeAll() const;

  /// The free angle, where the pattern's chains determine it.
  std::optional<double> turn(int vertex) const override;
  /// The neighbours in the pattern's chains. Where these end, the front is taken to run on
  /// straight; at a vertex without a chain, to run opposite to the base edge.
  std::optional<Point2> before(int vertex) const override;
  std::optional<Point2> after(int vertex) const override;
  /// Number of vertices in the base's chain, which is all that is known of its loop.
  int loopSize() const override;
  double distanceToFront(Point2 point) const override;

 protected:
  const RuleDefinition& definition() const { return *definition_; }

 private:
  Point2 at(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)]; }
  /// The vertex before or after a vertex in its chain, or -1.
  int previousOf(int vertex) const;
  int nextOf(int vertex) const;

  const RuleDefinition* definition_;
  std::vector<Point2> vertices_;
  int level_;
};

}  // namespace af2
