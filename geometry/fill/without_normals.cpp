#include "geometry/fill/without_normals.h"

#include <algorithm>

#include "engine/base/predicates.h"

namespace af2::geometry {

FrontInput withoutNormals(FrontInput input) {
  for (auto& loop : input.loops)
    for (BoundaryCorner& corner : loop) corner.point.normal = {};
  for (BoundaryCorner& corner : input.isolated) corner.point.normal = {};
  return input;
}

void restoreNormals(const ParametricSurface& surface, const FrontInput& input, Mesh& mesh) {
  for (std::size_t i = input.vertexCount; i < mesh.vertices.size(); ++i)
    mesh.vertices[i].normal = surface.pointAt(mesh.vertices[i].u, mesh.vertices[i].v).normal;
  const auto restore = [&](const BoundaryCorner& corner) {
    mesh.vertices[corner.vertex.value].normal = corner.point.normal;
  };
  for (const auto& loop : input.loops) std::ranges::for_each(loop, restore);
  std::ranges::for_each(input.isolated, restore);
}

bool isFlatInParameters(const Mesh& mesh, bool isFlipped) {
  const Turn wanted = isFlipped ? Turn::Right : Turn::Left;
  return std::ranges::all_of(mesh.elements, [&](const Element& element) {
    const auto c = element.vertices();
    for (std::size_t i = 0; i < c.size(); ++i) {
      const auto at = [&](std::size_t k) {
        const SurfacePoint& p = mesh.vertices[c[(i + k) % c.size()].value];
        return Point2{p.u, p.v};
      };
      if (orientation(at(0), at(1), at(2)) != wanted) return false;
    }
    return true;
  });
}

}  // namespace af2::geometry
