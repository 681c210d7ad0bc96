// The wanted sizes on a domain, by position and by curvature.
#pragma once

#include <memory>

#include "engine/base/export.h"
#include "geometry/sizes/sizes.h"

namespace af2::geometry {

/// Immutable; copies share what is large.
class AF2_EXPORT DomainSize {
 public:
  /// sizes  are kept as a reference
  explicit DomainSize(const Sizes& sizes);

  /// The same, but with another function of the position.
  DomainSize withFunction(PositionSize function) const;

  /// The wanted size at a position: `size`, or less where something there asks for less.
  double at(const Point3& position, double size) const;
  /// Whether sizes vary with the position.
  bool isVaried() const { return function_ || sources_; }
  /// The least size at turns: `gentleLeast` times the wanted size, or with `elementsPerTurn` the
  /// least of all sizes.
  double leastAtTurns(double gentleLeast) const;
  /// The largest edge length where a surface or a curve has the radius of curvature `radius`.
  /// At least `leastAtTurns`.
  double turnLimit(double radius, double gentleLeast) const;
  /// The largest angle, in radians, by which a segment may turn, if `elementsPerTurn` is given;
  /// else 0.
  double turnOfSegment() const;
  /// The angle, in radians, to which sizes limit the turn of a segment, given or not.
  double limitOfTurn() const;
  /// Whether the distance from the model is bounded.
  bool hasChord() const { return asked_->chords.areGiven(); }
  /// `size`, clamped to the bounds of all sizes.
  double bounded(double size) const;

 private:
  const Sizes* asked_;
  PositionSize function_;
  std::shared_ptr<const PositionSize> sources_;  ///< null: there are none
};

}  // namespace af2::geometry
