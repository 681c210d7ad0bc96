// A rigid motion that maps one face to another.
// Not installed.
#pragma once

#include <array>
#include <cmath>

#include "engine/base/elementary.h"
#include "engine/base/point.h"

namespace af2::geometry {

class FaceMap {
 public:
  explicit FaceMap(const std::array<double, 16>& matrix) : m_(matrix) {}

  static FaceMap translation(const Point3& by) {
    return FaceMap({1, 0, 0, by.x, 0, 1, 0, by.y, 0, 0, 1, by.z, 0, 0, 0, 1});
  }
  /// Around a line; axis of unit length, angle in radians.
  static FaceMap rotation(const Point3& onAxis, const Point3& axis, double angle) {
    const double c = cosine(angle), s = sine(angle), d = 1 - c;
    const auto& [x, y, z] = axis;
    FaceMap map({c + x * x * d, x * y * d - z * s, x * z * d + y * s, 0,  //
                 y * x * d + z * s, c + y * y * d, y * z * d - x * s, 0,  //
                 z * x * d - y * s, z * y * d + x * s, c + z * z * d, 0, 0, 0, 0, 1});
    const Point3 rest = onAxis - map.at(onAxis);
    map.m_[3] = rest.x;
    map.m_[7] = rest.y;
    map.m_[11] = rest.z;
    return map;
  }

  Point3 at(const Point3& p) const { return along(p) + Point3{m_[3], m_[7], m_[11]}; }
  /// Of a direction.
  Point3 along(const Point3& p) const {
    return {m_[0] * p.x + m_[1] * p.y + m_[2] * p.z, m_[4] * p.x + m_[5] * p.y + m_[6] * p.z,
            m_[8] * p.x + m_[9] * p.y + m_[10] * p.z};
  }
  FaceMap inverse() const {
    FaceMap back(
        {m_[0], m_[4], m_[8], 0, m_[1], m_[5], m_[9], 0, m_[2], m_[6], m_[10], 0, 0, 0, 0, 1});
    const Point3 shift = -1 * back.along({m_[3], m_[7], m_[11]});
    back.m_[3] = shift.x;
    back.m_[7] = shift.y;
    back.m_[11] = shift.z;
    return back;
  }
  const std::array<double, 16>& matrix() const { return m_; }

 private:
  std::array<double, 16> m_;
};

}  // namespace af2::geometry
