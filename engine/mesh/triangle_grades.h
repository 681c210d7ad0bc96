// What the optimiser knows of triangles, so that it need not look at most of them again.
#pragma once

#include "engine/mesh/element_shape.h"
#include "engine/mesh/mesh_topology.h"

namespace af2 {

/// Triangles with a grade of their own face the way the surface does.
enum class TriangleGrade : std::uint8_t { Unknown, Other, Good, Even };

/// Distortions: no swap improves two triangles below the first, and no vertex between triangles
/// below the second has far to go.
inline constexpr double kGoodTriangle = 1.05, kEvenTriangle = 1.002;

/// The grade of a triangle; Other for a quadrilateral. Looks at it only if it has changed.
inline TriangleGrade gradeOf(MeshTopology& topology, std::size_t e) {
  auto grade = static_cast<TriangleGrade>(topology.gradeOf(e));
  if (grade != TriangleGrade::Unknown) return grade;
  const Element& element = topology.mesh().elements[e];
  const auto at = [&](std::size_t i) -> const SurfacePoint& {
    return topology.mesh().vertices[element.corners[i].value];
  };
  grade = TriangleGrade::Other;
  if (!element.isQuad() && isPlainlyBelow(kGoodTriangle, at(0), at(1), at(2))) {
    const Point3 p = at(1).position - at(0).position, q = at(2).position - at(0).position;
    grade = isPlainlyBelow(kEvenTriangle, p, q, cross(p, q)) ? TriangleGrade::Even
                                                             : TriangleGrade::Good;
  }
  topology.setGrade(e, static_cast<std::uint8_t>(grade));
  return grade;
}

/// Whether a triangle is known to be below kGoodTriangle, which is so for most of them once they
/// have been looked at: only a byte is read.
inline bool isKnownGood(const MeshTopology& topology, std::size_t e) {
  return topology.gradeOf(e) >= static_cast<std::uint8_t>(TriangleGrade::Good);
}

/// Whether a triangle is known, or found, to be below kGoodTriangle.
inline bool isGood(MeshTopology& topology, std::size_t e) {
  return gradeOf(topology, e) >= TriangleGrade::Good;
}

}  // namespace af2
