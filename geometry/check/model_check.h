// Checks the mesh of a model against its boundary, before the mesh is written.
#pragma once

#include <string>
#include <vector>

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// A check that a mesh does not pass.
struct MeshFinding {
  int face = 0;  ///< where; 0: not on one face
  std::string what;
  Point3 place;
  bool operator==(const MeshFinding&) const = default;
};

/// Whether the area of the elements of a face is wrong, given its `ratio` to the area of the CAD
/// face. Straight elements differ in area from a curved face, and from a plane face with a curved
/// boundary; the fewer elements there are, the more they may differ.
AF2_EXPORT bool isWrongArea(double ratio, std::size_t elements);

/// Checks a mesh:
///   * every corner is a vertex of the mesh, no element repeats a corner or has no area;
///   * every piece of a model edge is used as often as its faces run along it;
///   * every other edge is used by two elements of the same face, in opposite directions;
///   * the area of each complete face is near that of the CAD face.
/// Findings come in the order of the elements and segments; at most `limit` of them, so that a mesh
/// that is wrong everywhere does not fill the memory. Large meshes are checked on up to `threads`
/// threads (0: as many as the caller's TBB arena has).
AF2_EXPORT std::vector<MeshFinding> checkModelMesh(const ModelMesh& mesh, std::size_t limit = 100,
                                                   int threads = 1);

}  // namespace af2::geometry
