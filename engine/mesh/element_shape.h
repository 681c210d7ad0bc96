// The orientation of elements, and their distortion, which the optimiser lowers: the inverse of the
// mean ratio.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/base/point.h"
#include "engine/base/predicates.h"
#include "engine/mesh/mesh.h"

namespace af2 {

/// Smallest cosine between a corner's normal and the surface normal (78 degrees): an element that
/// leans more is a fold of the mesh, not an approximation of the surface.
inline constexpr double kMinNormalCosine = 0.2;

/// Whether the angle between two directions is smaller than that; `normal` has the length 1.
///
/// squared  dot(turned, turned)
inline bool leansLittle(const Point3& turned, double squared, const Point3& normal) {
  const double cosine = dot(turned, normal);
  return (cosine > 0) & (cosine * cosine > kMinNormalCosine * kMinNormalCosine * squared);
}

/// Whether a corner faces the way the surface does; `turned` is the cross product of its edges. A
/// zero normal, as at a pole, accepts every direction.
inline bool facesNormal(const Point3& turned, const Point3& normal) {
  return leansLittle(turned, dot(turned, turned), normal) || normal == Point3{};
}
/// The same for the corner between two edges of an element.
inline bool facesNormal(const Point3& corner, const Point3& ahead, const Point3& behind,
                        const Point3& normal) {
  return facesNormal(cross(ahead - corner, behind - corner), normal);
}

/// Whether a quadrilateral turns back at a corner, against its own area. Where normals are unknown
/// or turn by much within the element, it can do so and face all of them.
inline bool turnsBackAt(std::span<const SurfacePoint* const> quad, std::size_t i) {
  const auto at = [&](std::size_t k) -> const Point3& { return quad[(i + k) % 4]->position; };
  return dot(cross(at(1) - at(0), at(3) - at(0)), cross(at(2) - at(0), at(3) - at(1))) < 0;
}

/// Whether some corner of an element does not face the way the surface does there.
inline bool leans(const Mesh& mesh, const Element& element) {
  const auto vertices = element.vertices();
  const std::size_t n = vertices.size();
  std::array<const SurfacePoint*, 4> corners{};
  for (std::size_t i = 0; i < n; ++i) corners[i] = &mesh.vertices[vertices[i].value];
  for (std::size_t i = 0; i < n; ++i)
    if (!facesNormal(corners[i]->position, corners[(i + 1) % n]->position,
                     corners[(i + n - 1) % n]->position, corners[i]->normal) ||
        (n == 4 && turnsBackAt(corners, i)))
      return true;
  return false;
}

/// Whether an element turns left at a corner, in a chart. Exact for a triangle. For a
/// quadrilateral, a corner that is straight within rounding does not count: on the surface it could
/// turn back.
inline bool turnsLeftAt(std::span<const Point2> corners, std::size_t i) {
  constexpr double kMinSine = 1e-9;
  const std::size_t n = corners.size();
  if (n == 3) return orientation(corners[0], corners[1], corners[2]) == Turn::Left;
  const Point2 ahead = corners[(i + 1) % n] - corners[i];
  const Point2 behind = corners[(i + n - 1) % n] - corners[i];
  const double turned = cross(ahead, behind);
  return turned > 0 &&
         turned * turned > kMinSine * kMinSine * dot(ahead, ahead) * dot(behind, behind);
}

/// Whether an element turns left at each corner.
inline bool turnsLeftEverywhere(std::span<const Point2> corners) {
  if (corners.size() == 3) return orientation(corners[0], corners[1], corners[2]) == Turn::Left;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (!turnsLeftAt(corners, i)) return false;
  return true;
}

/// Whether a quadrilateral turns left at all corners but one, so that its sides do not cross, and
/// has a positive area.
inline bool hasOneReflexCorner(std::span<const Point2> corners) {
  if (corners.size() != 4) return false;
  int others = 0;
  for (std::size_t i = 0; i < 4; ++i) others += !turnsLeftAt(corners, i);
  return others == 1 && cross(corners[2] - corners[0], corners[3] - corners[1]) > 0;
}

/// Sum of squared edge lengths over area, scaled to 1 for the ideal corner. Source: [Knupp01].
inline double cornerDistortion(const Point3& corner, const Point3& ahead, const Point3& behind,
                               bool ofTriangle) {
  constexpr double kTwoRootThree = 3.4641016151377544;
  const Point3 p = ahead - corner, q = behind - corner;
  const double twiceArea = length(cross(p, q));
  const double squares = dot(p, p) + dot(q, q);
  if (!(twiceArea > 0)) return INFINITY;
  if (!ofTriangle) return squares / (2 * twiceArea);
  const Point3 r = behind - ahead;
  return (squares + dot(r, r)) / (kTwoRootThree * twiceArea);
}

/// What the squared sum of the squared sides of a triangle, over the square of twice its area, is
/// below if its distortion is below a limit, by a margin far larger than any rounding error.
constexpr double plainLimit(double limit) {
  constexpr double kCertain = 1 - 1e-9, kTwelve = 12;  // (2 sqrt(3))^2
  return kCertain * kTwelve * limit * limit;
}

/// Whether the distortion of a triangle is certainly below a limit, whatever way it faces. Needs
/// neither a root nor a division. False means: not certain.
///
/// p, q    two of its sides, from the same corner
/// turned  cross(p, q)
inline bool isPlainlyBelow(double limit, const Point3& p, const Point3& q, const Point3& turned) {
  const Point3 r = q - p;
  const double squares = dot(p, p) + dot(q, q) + dot(r, r);
  return squares * squares < plainLimit(limit) * dot(turned, turned);
}

/// The same, and whether it faces the way the surface does.
inline bool isPlainlyBelow(double limit, const SurfacePoint& a, const SurfacePoint& b,
                           const SurfacePoint& c) {
  const Point3 p = b.position - a.position, q = c.position - a.position;
  const Point3 turned = cross(p, q);
  const double squared = dot(turned, turned);
  for (const SurfacePoint* corner : {&a, &b, &c})
    if (!leansLittle(turned, squared, corner->normal) && corner->normal != Point3{}) return false;
  return isPlainlyBelow(limit, p, q, turned);
}

/// Distortion of a triangle: 1 for the equilateral one, unbounded above, infinite for one that
/// folds against the surface.
inline double triangleDistortion(const SurfacePoint& a, const SurfacePoint& b,
                                 const SurfacePoint& c) {
  const Point3 turned = cross(b.position - a.position, c.position - a.position);
  for (const SurfacePoint* corner : {&a, &b, &c})
    if (!facesNormal(turned, corner->normal)) return INFINITY;
  return cornerDistortion(a.position, b.position, c.position, true);
}

/// The distortion of a triangle, or of the worst corner of a quadrilateral.
inline double elementDistortion(std::span<const SurfacePoint* const> corners) {
  const std::size_t n = corners.size();
  if (n == 3) return triangleDistortion(*corners[0], *corners[1], *corners[2]);
  double worst = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3& corner = corners[i]->position;
    const Point3& ahead = corners[i + 1 == n ? 0 : i + 1]->position;
    const Point3& behind = corners[i == 0 ? n - 1 : i - 1]->position;
    if (!facesNormal(corner, ahead, behind, corners[i]->normal) || turnsBackAt(corners, i))
      return INFINITY;
    worst = std::max(worst, cornerDistortion(corner, ahead, behind, false));
  }
  return worst;
}

}  // namespace af2
