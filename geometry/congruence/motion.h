// Rigid motions of space, with reflections.
#pragma once

#include "engine/base/point.h"

namespace af2::geometry {

/// Three directions at right angles, of unit length, and an origin. z may be on either side.
struct Frame {
  Point3 origin, x, y, z;
  /// With x from `p` to `q`, and `r` on the side of y. The three are not on one line.
  static Frame at(const Point3& p, const Point3& q, const Point3& r) {
    const Point3 x = unit(q - p), z = unit(cross(x, r - p));
    return {p, x, cross(z, x), z};
  }
  Frame reflected() const { return {origin, x, y, -1 * z}; }
};

/// A rotation, a reflection or both, and then a translation.
class Motion {
 public:
  /// Moves one frame onto another.
  Motion(const Frame& from, const Frame& to) : from_(from), to_(to) {}
  Point3 moved(const Point3& place) const { return to_.origin + turned(place - from_.origin); }
  Point3 turned(const Point3& direction) const {
    return dot(from_.x, direction) * to_.x + dot(from_.y, direction) * to_.y +
           dot(from_.z, direction) * to_.z;
  }

 private:
  Frame from_, to_;
};

}  // namespace af2::geometry
