// A free zone that the rule language lacks: an ellipse with given foci.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include <af2/dsl/covering_zone.h>

/// The points whose distances from two foci have a sum of at most `reach`.
///
/// A registered shape defines its bounding box (`boundingBox`), which points it contains
/// (`contains`) and which edges enter it (`meets`). This one also defines which edges lie inside it
/// (`covers`), so that rules may subtract it from other shapes.
class Egg final : public af2::dsl::CoveringZone {
 public:
  Egg(af2::Point2 first, af2::Point2 second, double reach)
      : first_(first), second_(second), reach_(reach) {}

  af2::Box2 boundingBox() const override {
    const af2::Point2 centre = first_ + 0.5 * (second_ - first_);
    const double half = 0.5 * reach_;
    return {{centre.x - half, centre.y - half}, {centre.x + half, centre.y + half}};
  }

  bool contains(af2::Point2 point, af2::ZoneBoundary boundary) const override {
    return boundary == af2::ZoneBoundary::Counts ? sum(point) <= reach_ : sum(point) < reach_;
  }

  /// The sum of distances is convex along an edge, so its minimum is found by ternary search.
  bool meets(af2::Point2 from, af2::Point2 to, af2::ZoneBoundary boundary) const override {
    double low = 0, high = 1;
    for (int i = 0; i < 100; ++i) {
      const double third = (high - low) / 3;
      const af2::Point2 p = from + (low + third) * (to - from);
      const af2::Point2 q = from + (high - third) * (to - from);
      if (contains(p, boundary) || contains(q, boundary)) return true;
      if (sum(p) < sum(q))
        high -= third;
      else
        low += third;
    }
    return contains(from, boundary) || contains(to, boundary);
  }

  /// The shape is convex, so testing the two ends is enough.
  bool covers(af2::Point2 from, af2::Point2 to) const override {
    return contains(from, af2::ZoneBoundary::Counts) && contains(to, af2::ZoneBoundary::Counts);
  }

 private:
  double sum(af2::Point2 p) const { return distance(p, first_) + distance(p, second_); }

  af2::Point2 first_, second_;
  double reach_;
};

/// egg(p, q, reach): makes a zone from the numbers of a call, or refuses where there is none.
inline af2::AF2FreeZoneDef::Made makeEgg(std::span<const double> n) {
  const af2::Point2 first{n[0], n[1]}, second{n[2], n[3]};
  if (!(distance(first, second) < n[4])) return {nullptr, af2::Refusal::Shape};
  return {std::make_unique<Egg>(first, second, n[4]), af2::Refusal::None};
}
