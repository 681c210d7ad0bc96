// A rule set: rules with their common levels, tolerances, element metric and front order.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/rule/element_metric.h"
#include "engine/rule/front_order.h"
#include "engine/rule/rule.h"

namespace af2 {

/// Which length becomes 1 in the chart.
enum class ChartUnit { WantedLength, BaseLength };

/// Even: every rule changes the number of front edges by an even number, and no step may divide an
/// even loop into two odd ones, so that a region with even loops is filled with quadrilaterals.
enum class Parity { Any, Even };

/// When rows change the number of their elements: where the edges at a vertex are longer or shorter
/// than this, in wanted lengths, the vertex wants one element more or less.
struct ColumnLimits {
  double shortest = 0, longest = 0;
  int firstLayer = 0;  ///< vertices in lower layers keep their counts
};

/// What happens to a mesh after its front has closed.
enum class Finish {
  Shape,  ///< changes towards equilateral triangles and squares
  Score,  ///< changes that lower the badness by the metric of the rule set
  None,   ///< the mesh stays as the front made it
};

/// A rule set as it is written, before it is checked.
struct RuleSetDefinition {
  std::string name;
  int maxLevel = 50;  ///< an edge that no rule accepts at this level is stuck
  /// Largest value of a tolerance form by level; [0] is level 1. Has maxLevel entries.
  std::vector<double> matchTolerance;
  std::shared_ptr<const AF2ElementMetric> metric;
  ScoreOf scoreOf = ScoreOf::Max;
  std::shared_ptr<const AF2Acceptance> acceptance;  ///< null: every score is accepted
  std::shared_ptr<const AF2FrontOrder> order;
  ChartUnit unit = ChartUnit::WantedLength;
  Parity parity = Parity::Any;
  /// Smallest distance of new edges from front edges of which no match is part, in chart units, by
  /// level; [0] is level 1. Edges that share an end are exempt. Empty, or with maxLevel entries.
  std::vector<double> clearance;
  std::optional<ColumnLimits> columns;
  int rowRounds = 0;  ///< rounds of smoothing of the front at the end of each row
  /// How deep the clean-up of quadrilaterals searches unless the caller says it: see QuadCleanUp.
  std::optional<int> cleanDepth;
  Finish finish = Finish::Shape;
  std::vector<AF2Rule> rules;  ///< in file order; ties go to the earlier rule
};

/// An immutable, consistent rule set, which determines all behaviour of a run of the engine.
class AF2_EXPORT RuleSet {
 public:
  /// Throws InputError, naming the rule set, if something is missing or contradictory.
  explicit RuleSet(RuleSetDefinition definition);

  const RuleSetDefinition& definition() const { return definition_; }
  const std::string& name() const { return definition_.name; }
  const std::vector<AF2Rule>& rules() const { return definition_.rules; }
  int maxLevel() const { return definition_.maxLevel; }
  double matchTolerance(int level) const;
  /// Whether any rule makes triangles; quadrilaterals.
  bool makesTriangles() const;
  bool makesQuads() const;

 private:
  RuleSetDefinition definition_;
};

}  // namespace af2
