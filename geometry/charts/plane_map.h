// Maps a whole face to one plane, so that its front runs there as on a plane face.
#pragma once

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2::geometry {

/// One-to-one on the face, with lengths in the plane that differ from those on the surface by a
/// factor that is the same in all directions. Seen from the side to which the plane's z axis
/// points, the face is seen from the side to which its own normals point.
class AF2_EXPORT PlaneMap {
 public:
  virtual ~PlaneMap() = default;
  /// The place in the plane of a point that is given by its parameters.
  virtual Point2 flatten(const SurfacePoint& point) const = 0;
  /// The point of the surface, with the face's normal and parameters.
  virtual SurfacePoint lift(Point2 place) const = 0;
  /// Length in the plane per unit of length on the surface.
  virtual double scaleAt(Point2) const { return 1; }
  /// The gradient of the logarithm of the scale.
  virtual Point2 scaleGradientAt(Point2) const { return {0, 0}; }
};

}  // namespace af2::geometry
