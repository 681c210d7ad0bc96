// Measures how far points are from the surface of a face.
// Not installed.
#pragma once

#include "engine/base/point.h"

namespace af2::geometry {

/// For one thread at a time. Successive points should be near each other.
class FaceDistance {
 public:
  virtual ~FaceDistance() = default;
  /// The distance from the nearest point of the surface that was found.
  virtual double of(const Point3& point) = 0;
};

}  // namespace af2::geometry
