// The engine's answers when a rule asks about more than the matched positions.
#pragma once

#include <vector>

#include "engine/rule/binding.h"
#include "engine/step/rule_matcher.h"
#include "engine/surface/size_field.h"

namespace af2 {

class FrontSurroundings final : public AF2Surroundings {
 public:
  FrontSurroundings(const StepView& view, const FrontIndex& index, const AF2Rule& rule,
                    const Match& match, const SizeField& size,
                    const std::vector<std::uint8_t>& valence)
      : view_(view), index_(index), rule_(rule), match_(match), size_(size), valence_(valence) {}

  double size(Point2 point) const override;
  std::optional<double> turn(int vertex) const override;
  int layer(int vertex) const override { return placeOf(vertex).layer; }
  bool onBoundary(int vertex) const override { return placeOf(vertex).layer == 0; }
  bool isFixed(int vertex) const override {
    return placeOf(vertex).vertex.value < view_.front.fixedCount();
  }
  double sizeOf(int vertex) const override { return placeOf(vertex).size / view_.chart.unit(); }
  std::optional<Point2> before(int vertex) const override;
  std::optional<Point2> after(int vertex) const override;
  int count(int vertex, const std::array<double, 3>& bounds) const override;
  int valence(int vertex) const override { return valence_[placeOf(vertex).vertex.value]; }
  int loopSize() const override { return view_.front.loopSize(view_.base); }
  double distanceToFront(Point2 point) const override;
  double curvature(Point2 point) const override;

 private:
  /// Distance to the edges there, but at most `nearest`.
  double nearestEdge(const Neighborhood& near, Point2 point, double nearest) const;
  PlaceId idOf(int vertex) const { return match_.places[static_cast<std::size_t>(vertex)]; }
  const Place& placeOf(int vertex) const { return view_.front[idOf(vertex)]; }
  /// Whether the vertex stands for one corner of the front. Another may have several, and the rule
  /// does not say which.
  bool hasOnePlace(int vertex) const;
  Point2 positionOf(PlaceId place) const;

  const StepView& view_;
  const FrontIndex& index_;
  const AF2Rule& rule_;
  const Match& match_;
  const SizeField& size_;
  const std::vector<std::uint8_t>& valence_;
};

}  // namespace af2
