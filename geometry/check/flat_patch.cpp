#include "geometry/check/flat_patch.h"

#include <algorithm>
#include <cmath>

#include "geometry/check/drawn_part.h"

namespace af2::geometry {
namespace {

/// Whether a flat patch is on one side of the plane of another one. As all its elements face the
/// same way, no vertex is beyond its boundary.
bool isOnOneSide(const ModelMesh& mesh, const OutlinedPatch& patch, const FlatPatch& plane,
                 double depth) {
  bool isAbove = true, isBelow = true;
  for (const std::uint32_t v : patch.onSegments) {
    const double at = dot(plane.normal, mesh.vertices[v]);
    isAbove &= at > plane.high - depth / 2;
    isBelow &= at < plane.low + depth / 2;
    if (!isAbove && !isBelow) return false;
  }
  return true;
}

}  // namespace

std::optional<FlatPatch> flatPatchOf(const ModelMesh& mesh, const OutlinedPatch& patch,
                                     double depth) {
  const Point3 normal = unit(patch.normal);
  if (normal == Point3{} || patch.onSegments.empty()) return std::nullopt;
  FlatPatch flat{normal, INFINITY, -INFINITY};
  for (std::size_t i = patch.first; i < patch.last; ++i)
    for (const VertexId v : mesh.elements[i].vertices()) {
      const double at = dot(normal, mesh.vertices[v.value]);
      flat.low = std::min(flat.low, at);
      flat.high = std::max(flat.high, at);
      if (!(flat.high - flat.low < depth / 2)) return std::nullopt;
    }
  if (!allFace({mesh, patch.first, patch.last - patch.first}, normal)) return std::nullopt;
  return flat;
}

bool arePartedByAPlane(const ModelMesh& mesh, const OutlinedPatch& one, const FlatPatch& flatOne,
                       const OutlinedPatch& other, const FlatPatch& flatOther, double depth) {
  constexpr double kAngle = 0.05;  // far above that of elements that overlap at an edge
  if (!(length(cross(flatOne.normal, flatOther.normal)) > kAngle)) return false;
  return isOnOneSide(mesh, one, flatOther, depth) || isOnOneSide(mesh, other, flatOne, depth);
}

}  // namespace af2::geometry
