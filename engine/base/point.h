// Points and vectors in the chart (2-D) and in space (3-D), and their arithmetic.
#pragma once

#include <cmath>

namespace af2 {

/// A point or vector in a chart. The unit is the wanted edge length.
struct Point2 {
  double x = 0, y = 0;
  bool operator==(const Point2&) const = default;
};

/// A point or vector in space, in model units.
struct Point3 {
  double x = 0, y = 0, z = 0;
  bool operator==(const Point3&) const = default;
};

/// A point on a surface, with the surface's normal and parameters there.
struct SurfacePoint {
  Point3 position;
  Point3 normal;  ///< unit length, towards the side from which the face is seen; zero if undefined
  /// Surface parameters; on a seam those of the side that the curve comes from.
  double u = 0, v = 0;
  bool operator==(const SurfacePoint&) const = default;
};

inline Point2 operator+(Point2 p, Point2 q) { return {p.x + q.x, p.y + q.y}; }
inline Point2 operator-(Point2 p, Point2 q) { return {p.x - q.x, p.y - q.y}; }
inline Point2 operator*(double s, Point2 p) { return {s * p.x, s * p.y}; }
inline double dot(Point2 p, Point2 q) { return p.x * q.x + p.y * q.y; }
inline double cross(Point2 p, Point2 q) { return p.x * q.y - p.y * q.x; }
inline double length(Point2 p) { return std::sqrt(dot(p, p)); }
inline double distance(Point2 p, Point2 q) { return length(q - p); }

inline Point3 operator+(const Point3& p, const Point3& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}
inline Point3 operator-(const Point3& p, const Point3& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
inline Point3 operator*(double s, const Point3& p) { return {s * p.x, s * p.y, s * p.z}; }
inline double dot(const Point3& p, const Point3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
inline Point3 cross(const Point3& p, const Point3& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
inline double length(const Point3& p) { return std::sqrt(dot(p, p)); }
inline double distance(const Point3& p, const Point3& q) { return length(q - p); }

/// `p` scaled to length 1; the zero vector stays zero.
inline Point3 unit(const Point3& p) {
  const double size = length(p);
  return size > 0 ? (1 / size) * p : Point3{};
}

}  // namespace af2
