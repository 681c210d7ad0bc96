// A part of a mesh that is looked at at once: all of it, or one face of a mesh on disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "engine/base/point.h"
#include "engine/mesh/mesh.h"

namespace af2::geometry {

/// Consecutive elements of a mesh, and the vertices that no slice before them has. The corners of
/// its elements are among these vertices and the shared ones.
struct MeshSlice {
  std::size_t firstVertex = 0, firstElement = 0;  ///< ids in the mesh
  std::span<const Point3> vertices;
  std::span<const double> wantedSizes;  ///< by vertex; may be empty
  std::span<const Element> elements;    ///< corners: ids in the mesh
  std::span<const ElementOrigin> origins;
  std::span<const float> scores;  ///< by element; may be empty
  /// By element: id of the model face. Empty: all have `onlyFace`.
  std::span<const std::int32_t> faces;
  std::int32_t onlyFace = 0;
  /// The first vertices of the mesh, which several slices use, and their sizes.
  std::span<const Point3> shared = {};
  std::span<const double> sharedSizes = {};

  std::int32_t face(std::size_t element) const { return faces.empty() ? onlyFace : faces[element]; }
  const Point3& position(VertexId v) const {
    return v.value < firstVertex ? shared[v.value] : vertices[v.value - firstVertex];
  }
  double wantedSize(VertexId v) const {
    return v.value < firstVertex ? sharedSizes[v.value] : wantedSizes[v.value - firstVertex];
  }
};

using SliceVisit = std::function<void(const MeshSlice&)>;

}  // namespace af2::geometry
