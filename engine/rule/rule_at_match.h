// What a rule says by itself at a match: whether the pattern fits, whether its conditions hold,
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

/// A reason for a refusal, with the numbers behind it.
struct RefusalCause {
  Refusal reason = Refusal::None;
  /// Of what the rule lists: the pattern vertex or edge, the condition, the new vertex, the
  /// element; -1 where the reason is not about one of them.
  int index = -1;
  bool isEdge = false;          ///< Pattern: `index` is that of a pattern edge, whose slope misfits
  double value = 0, limit = 0;  ///< Pattern: the tolerance form and the largest allowed value

  bool isNone() const { return reason == Refusal::None; }
};

/// Pattern if a vertex or a slope deviates by more than is allowed, else None.
///
/// matched    positions in pattern order; the ends of the base edge are not tested
/// tolerance  largest allowed value of a tolerance form at the level
AF2_EXPORT RefusalCause patternMisfit(const RuleDefinition& rule, std::span<const Point2> matched,
                                      int level, double tolerance);

/// Require or NoValue for the first condition that does not hold, else None.
AF2_EXPORT RefusalCause failedRequirement(const RuleDefinition& rule, const AF2Binding& binding);

/// Where one of the new vertices goes; nothing where that has no finite value.
AF2_EXPORT std::optional<Point2> newVertexAt(const RuleDefinition& rule, std::size_t index,
                                             const AF2Binding& binding);
AF2_EXPORT std::vector<std::optional<Point2>> newVerticesAt(const RuleDefinition& rule,
                                                            const AF2Binding& binding);

/// What the rule adds to its score, 0 for most; nothing where that has no finite value.
AF2_EXPORT std::optional<double> costAt(const RuleDefinition& rule, const AF2Binding& binding);

/// A rule at given positions of its pattern. The front around them consists of the pattern's edges
/// and isolated vertices, and of nothing else; sizes are uniform, the surface is a plane.
class AF2_EXPORT RuleAtMatch : public AF2Surroundings {
 public:
  /// vertices  the matched ones in pattern order; [0] and [1] on the x axis
  /// `rule` is kept as a reference.
  RuleAtMatch(const RuleDefinition& rule, std::vector<Point2> vertices, int level);
  /// Where the pattern wants its vertices.
  static RuleAtMatch atReference(const RuleDefinition& rule, int level);

  const std::vector<Point2>& vertices() const { return vertices_; }
  int level() const { return level_; }
  AF2Binding binding() const { return {vertices_, level_, this}; }
  /// Matched and new vertices; nothing where a new one has no place.
  std::optional<std::vector<Point2>> placeAll() const;

  /// The free angle, where the pattern's chains fix it.
  std::optional<double> turn(int vertex) const override;
  /// Vertices in the chain of the base: all there is of its loop.
  int loopSize() const override;
  double distanceToFront(Point2 point) const override;

 protected:
  const RuleDefinition& definition() const { return *definition_; }

 private:
  Point2 at(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)]; }
  /// The vertex before or after one in its chain, or -1.
  int before(int vertex) const;
  int after(int vertex) const;

  const RuleDefinition* definition_;
  std::vector<Point2> vertices_;
  int level_;
};

}  // namespace af2
