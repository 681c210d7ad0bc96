// The badness of the elements of a mesh on a surface, by the metric of a rule set.
#pragma once

#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/rule/rule_set.h"
#include "engine/surface/local_transform.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// Evaluates elements at level 1, each in the chart of its first side. The unit of this chart is
/// that of the rule set: the mean of the wanted lengths at the ends of the side, or its length.
///
/// The badness of an element depends on nothing but its corners. So a change that lowers the worst
/// badness among the elements that it touches cannot raise the worst badness of the mesh.
class ElementBadness {
 public:
  ElementBadness(const Mesh& mesh, const RuleSet& rules, const AF2LocalTransformMaker& charts,
                 const SizeField& size);

  /// Infinite if the metric has no value, or if the element is not acceptable: it does not turn
  /// left at each corner, leans against the surface, or has no chart.
  double of(const Element& element);
  /// The rotation of a triangle with the smallest badness; ties go to the earlier one. A metric may
  /// distinguish the corners, and no rule says which corner of a new triangle comes first.
  Element bestRotation(Element triangle);

  /// Must be called after a vertex was moved: the wanted length may differ there.
  void forget(VertexId moved) { sizes_[moved.value] = kUnknown; }

 private:
  static constexpr double kUnknown = -1;

  const SurfacePoint& at(VertexId v) const { return mesh_.vertices[v.value]; }
  double sizeAt(VertexId v);
  double unitOf(VertexId from, VertexId to);
  double inItsChart(const Element& element, double unit);

  const Mesh& mesh_;
  const AF2ElementMetric& metric_;
  ChartUnit unit_;
  const AF2LocalTransformMaker& charts_;
  const SizeField& size_;
  std::vector<double> sizes_;  ///< by vertex; a size field may be slow
  ChartSlot slot_;
};

}  // namespace af2
