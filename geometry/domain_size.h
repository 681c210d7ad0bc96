// The sizes that the options of a domain want, by position and where something turns.
#pragma once

#include "engine/size_field.h"
#include "geometry/domain_options.h"

namespace af2::geometry {

class DomainSize final : public SizeField {
 public:
  /// options  are kept as a reference
  explicit DomainSize(const DomainMeshingOptions& options);

  double sizeAt(const SurfacePoint& point) const override { return at(point.position); }
  double at(const Point3& position) const;
  /// Whether sizes differ from place to place.
  bool isVaried() const { return options_.function || sources_; }
  /// `size`, or less where a surface or a curve turns within `radius`. Unless turns were asked for,
  /// this goes down to `gentleLeast` times the wanted size.
  double limitedByTurn(double size, double radius, double gentleLeast) const;

 private:
  double bounded(double size) const;

  const DomainMeshingOptions& options_;
  PositionSize sources_;
};

}  // namespace af2::geometry
