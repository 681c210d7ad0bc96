// A rule at given positions, with the front that its chains and the caller define.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "engine/rule/rule_at_match.h"

namespace af2::dsl {

class GivenMatch final : public RuleAtMatch {
 public:
  /// matched      positions in pattern order
  /// environment  answers by name: h, loop_size, dist_front, curvature, and for a vertex c of the
  ///              pattern layer(c), turn(c) in degrees, count(c), valence(c), on_boundary(c),
  ///              fixed(c); without a vertex, `layer`, `turn`, ... apply to all vertices
  GivenMatch(const RuleDefinition& rule, std::vector<Point2> matched, int level,
             std::map<std::string, double> environment = {});

  double size(Point2 point) const override;
  double sizeOf(int vertex) const override;
  std::optional<double> turn(int vertex) const override;
  int layer(int vertex) const override;
  bool onBoundary(int vertex) const override;
  bool isFixed(int vertex) const override;
  int count(int vertex, const std::array<double, 3>& bounds) const override;
  int valence(int vertex) const override;
  int loopSize() const override;
  double distanceToFront(Point2 point) const override;
  double curvature(Point2 point) const override;

 private:
  std::optional<double> given(const std::string& name) const;
  std::optional<double> given(const std::string& name, int vertex) const;

  std::map<std::string, double> environment_;
};

}  // namespace af2::dsl
