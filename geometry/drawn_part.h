// Whether some elements of a mesh can be drawn in a plane without overlaps: then they cannot cross
// each other.
// Not installed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "geometry/model_mesh.h"

namespace af2::geometry {

/// Some elements of a mesh: those from `first` on, or those at `places` from there on.
struct MeshPart {
  const ModelMesh& mesh;
  std::size_t first = 0, count = 0;
  const std::uint32_t* places = nullptr;  ///< `count` of them, or null

  std::span<const VertexId> corners(std::size_t i) const {
    return mesh.elements[first + (places ? places[i] : i)].vertices();
  }
};

/// The normal of a plane to one side of which all elements of the part look, and not too flatly;
/// nothing if the mean of their normals is none.
std::optional<Point3> commonNormal(const MeshPart& part);

/// Whether the part can be seen to lie over itself nowhere: all of its elements look to one side of
/// a plane, and its outline, drawn in the plane, crosses itself nowhere and has the part on its
/// left and nothing on its right. False says nothing.
///
/// The elements must be conforming and oriented alike.
bool canBeDrawn(const MeshPart& part);

}  // namespace af2::geometry
