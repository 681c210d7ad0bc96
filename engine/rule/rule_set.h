// A rule set: rules with their common levels, tolerances, element metric and front order.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/rule/element_metric.h"
#include "engine/rule/front_order.h"
#include "engine/rule/rule.h"

namespace af2 {

/// Which length becomes 1 in the chart.
enum class ChartUnit { WantedLength, BaseLength };

/// Whether every rule must change the number of front edges by an even number.
enum class Parity { Any, Even };

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
