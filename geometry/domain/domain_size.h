// The sizes that the options of a domain want, by position and where something turns.
#pragma once

#include <memory>

#include "geometry/domain/domain_options.h"

namespace af2::geometry {

/// Immutable; copies share what is large.
class DomainSize {
 public:
  /// options  are kept as a reference
  explicit DomainSize(const DomainMeshingOptions& options);

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
  const DomainMeshingOptions* options_;
  PositionSize function_;
  std::shared_ptr<const PositionSize> sources_;  ///< null: there are none
};

}  // namespace af2::geometry
