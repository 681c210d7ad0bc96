// Splits elements into triangles, for formats that support nothing else. Not installed.
#pragma once

#include <array>
#include <vector>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// A quadrilateral is split along the shorter diagonal, the first one if both are equally long.
///
/// at  the position of a vertex
template <class At>
std::vector<std::array<VertexId, 3>> trianglesBetween(const Element& element, const At& at) {
  const auto& [a, b, c, d] = element.corners;
  if (!element.isQuad()) return {{a, b, c}};
  const bool alongAc = distance(at(a), at(c)) <= distance(at(b), at(d));
  if (alongAc) return {{a, b, c}, {a, c, d}};
  return {{a, b, d}, {b, c, d}};
}
inline std::vector<std::array<VertexId, 3>> trianglesOf(const ModelMesh& mesh,
                                                        const Element& element) {
  return trianglesBetween(element, [&](VertexId v) { return mesh.vertices[v.value]; });
}
inline std::vector<std::array<VertexId, 3>> trianglesOf(const MeshSlice& slice,
                                                        const Element& element) {
  return trianglesBetween(element, [&](VertexId v) { return slice.position(v); });
}

}  // namespace af2::geometry
