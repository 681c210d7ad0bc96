// A rule at given positions, with as much of a front around it as its chains and the caller tell.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/rule/binding.h"
#include "engine/rule/rule.h"

namespace af2::dsl {

class GivenMatch final : public AF2Surroundings {
 public:
  /// matched      positions in pattern order
  /// environment  answers by name: h, loop_size, dist_front, curvature, and for a vertex c of the
  ///              pattern layer(c), turn(c) in degrees, valence(c), on_boundary(c); without a
  ///              vertex layer, turn, ... hold for all of them
  GivenMatch(const RuleDefinition& rule, std::vector<Point2> matched, int level,
             std::map<std::string, double> environment = {});

  AF2Binding binding() const { return {matched_, level_, this}; }
  const std::vector<Point2>& matched() const { return matched_; }

  double size(Point2) const override { return value("h", 1); }
  std::optional<double> turn(int vertex) const override;
  int layer(int vertex) const override { return static_cast<int>(ofVertex("layer", vertex, 0)); }
  bool onBoundary(int vertex) const override { return ofVertex("on_boundary", vertex, 1) != 0; }
  int valence(int vertex) const override {
    return static_cast<int>(ofVertex("valence", vertex, 0));
  }
  int loopSize() const override { return static_cast<int>(value("loop_size", 0)); }
  double distanceToFront(Point2) const override { return value("dist_front", 0); }
  double curvature(Point2) const override { return value("curvature", 0); }

 private:
  double value(const std::string& name, double otherwise) const;
  double ofVertex(const std::string& name, int vertex, double otherwise) const;

  const RuleDefinition& rule_;
  std::vector<Point2> matched_;
  int level_;
  std::map<std::string, double> environment_;
};

}  // namespace af2::dsl
