// Divides a mesh into parts, without having all of it in memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/model_mesh.h"
#include "geometry/mpi/partition/patch_tree.h"

namespace af2::mpi {

/// The part of each element, and the parts at each vertex that several faces may have.
struct MeshDivision {
  int parts = 1;
  /// The patches of the elements of one face, by their middles.
  struct FacePatches {
    PatchTree tree;
    std::uint32_t first = 0;  ///< the number of its first patch in the mesh
  };
  std::vector<FacePatches> faces;         ///< by item of elementsByFace
  std::vector<std::int32_t> partOfPatch;  ///< by number of the patch in the mesh

  /// Those at vertex v < insideFrom, ascending: partsAt[begin[v]] to before partsAt[begin[v + 1]].
  /// Vertices from `insideFrom` on belong to one face only.
  std::uint32_t insideFrom = 0;
  std::vector<std::size_t> begin{0};
  std::vector<std::int32_t> partsAt;

  std::span<const std::int32_t> partsAtVertex(std::uint32_t v) const {
    return std::span(partsAt).subspan(begin[v], begin[v + 1] - begin[v]);
  }
};

/// The mean of the corners of an element of a slice.
Point3 middleOf(const geometry::MeshSlice& slice, std::size_t element);

/// Calls visit(slice, face, f) for each item of elementsByFace, which is number f, with the slice
/// that has it.
void forEachFaceOf(const geometry::ModelMesh& mesh, const auto& visit) {
  const std::vector<geometry::FaceElements> faces = elementsByFace(mesh);
  std::size_t f = 0;
  forEachSlice(mesh, [&](const geometry::MeshSlice& slice) {
    const std::size_t end = slice.firstElement + slice.elements.size();
    for (; f < faces.size() && faces[f].first < end; ++f) visit(slice, faces[f], f);
  });
}

/// Divides the faces into patches, and the graph of the patches by METIS. Parts have about the same
/// number of elements and short borders. The same mesh is divided in the same way each time.
MeshDivision divideMesh(const geometry::ModelMesh& mesh, int parts);

}  // namespace af2::mpi
