// The sizes that are wanted on a domain, by position and where something turns.
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

  /// What is wanted at a position where `size` is wanted unless something there wants less.
  double at(const Point3& position, double size) const;
  /// Whether sizes differ from place to place.
  bool isVaried() const { return function_ || sources_; }
  /// The largest edges where a surface or a curve turns within `radius`. Unless turns were asked
  /// for, this goes down to `gentleLeast` times the wanted size.
  double turnLimit(double radius, double gentleLeast) const;
  /// By how much a segment may turn, in radians, if turns were asked for; else 0.
  double turnOfSegment() const;
  /// `size`, brought between the bounds of all sizes.
  double bounded(double size) const;

 private:
  const Sizes* asked_;
  PositionSize function_;
  std::shared_ptr<const PositionSize> sources_;  ///< null: there are none
};

}  // namespace af2::geometry
