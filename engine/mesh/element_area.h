// The area of an element. Not installed.
#pragma once

#include "engine/mesh/mesh.h"

namespace af2 {

/// Of a quadrilateral that is not plane: the length of its area vector.
inline double areaOf(const Mesh& mesh, const Element& element) {
  const auto c = element.vertices();
  const auto at = [&](std::size_t i) -> const Point3& {
    return mesh.vertices[c[i].value].position;
  };
  Point3 sum;
  for (std::size_t i = 1; i + 1 < c.size(); ++i)
    sum = sum + cross(at(i) - at(0), at(i + 1) - at(0));
  return length(sum) / 2;
}

}  // namespace af2
