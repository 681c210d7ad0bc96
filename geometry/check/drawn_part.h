// Whether some elements of a mesh project to a plane without overlaps: then they cannot cross.
// Not installed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Least cosine of the angle between an element and the plane to which it is projected.
inline constexpr double kMinFacing = 0.1;

/// Some elements of a mesh: `count` elements from `first` on, or those at the offsets `places` from
/// `first`.
struct MeshPart {
  const ModelMesh& mesh;
  std::size_t first = 0, count = 0;
  const std::uint32_t* places = nullptr;  ///< `count` of them, or null

  /// Calls visit with the normal of each half of a quadrilateral and of each triangle; its length
  /// is twice the area.
  template <class Visit>
  void forEachNormal(std::size_t i, const Visit& visit) const {
    const auto all = corners(i);
    const Point3& origin = mesh.vertices[all[0].value];
    for (std::size_t k = 1; k + 1 < all.size(); ++k)
      visit(cross(mesh.vertices[all[k].value] - origin, mesh.vertices[all[k + 1].value] - origin));
  }
  std::span<const VertexId> corners(std::size_t i) const {
    return mesh.elements[first + (places ? places[i] : i)].vertices();
  }
};

/// Whether all elements of the part face the side of a plane to which its unit normal points,
/// within the angle that kMinFacing allows.
bool allFace(const MeshPart& part, const Point3& normal);

/// Whether a projection proves that the part does not overlap itself: all of its elements face one
/// side of a plane, and its outline, projected to the plane, does not cross itself and has the part
/// on its left and nothing on its right. False proves nothing.
///
/// The elements must be conforming and oriented alike.
bool canBeDrawn(const MeshPart& part);

}  // namespace af2::geometry
