// Walks straight on over a surface. Not installed.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/charts/charted_surface.h"

namespace af2::geometry {

/// Gives a point of a surface its parameters (u, v), starting from those of a point nearby.
using PlaceInParameters =
    std::function<SurfacePoint(const SurfacePoint& point, double u, double v)>;

/// For one thread.
class SurfaceWalk {
 public:
  /// surface, place  are kept as references
  SurfaceWalk(const ChartedSurface& surface, const PlaceInParameters& place);

  /// The points at these distances from a point, straight on over the surface. There are fewer
  /// where the surface cannot be reached any more.
  ///
  /// direction  unit vector, tangential to the surface
  /// distances  ascending, > 0
  std::vector<SurfacePoint> along(const SurfacePoint& from, const Point3& direction,
                                  const std::vector<double>& distances) const;

 private:
  std::optional<SurfacePoint> step(const SurfacePoint& from, const Point3& direction, double length,
                                   int halvings) const;

  const PlaceInParameters& place_;
  std::unique_ptr<AF2LocalTransformMaker> charts_;
};

/// For surfaces with parameters.
PlaceInParameters placeInParametersOf(const ChartedSurface& surface);

}  // namespace af2::geometry
