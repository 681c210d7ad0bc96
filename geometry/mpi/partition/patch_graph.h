// The patches of a mesh and which of them lie beside each other.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/mpi/partition/divide_mesh.h"

namespace af2::mpi {

struct PatchGraph {
  std::vector<MeshDivision::FacePatches> faces;
  std::vector<std::uint64_t> elements;  ///< by patch: how many it has
  /// Patches with common sides of elements, each pair twice, ascending, and how many sides these
  /// are.
  struct Link {
    std::uint32_t from = 0, to = 0;
    std::uint64_t sides = 0;
  };
  std::vector<Link> links;
  std::uint32_t insideFrom = 0;  ///< as in MeshDivision
  /// Vertices below that, and the patches that have them, ascending.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> atVertices;
};

/// most  elements of a patch
PatchGraph patchGraph(const geometry::ModelMesh& mesh, std::size_t most);

/// parts  by patch
MeshDivision divisionInto(int count, std::vector<std::int32_t> parts, PatchGraph graph);

}  // namespace af2::mpi
