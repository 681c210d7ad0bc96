// A mesh as Gmsh's formats see it: by entities of the model, with their physical groups.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/base/box_tree.h"
#include "geometry/formats/element_vertices.h"
#include "geometry/formats/msh_groups.h"
#include "geometry/formats/msh_volumes.h"

namespace af2::geometry {

/// The mesh of one model edge or face; or a solid, which has none.
struct MshEntity {
  std::int32_t dimension = PhysicalGroup::kSurface;
  std::int32_t id = 0;               ///< of the edge, face or solid
  std::vector<std::int32_t> groups;  ///< physical groups: of a face, its own first
  Box3 box;
  std::vector<std::uint32_t> vertices;  ///< those that no earlier entity has
  std::vector<std::uint32_t> lines, triangles, quads;
  std::vector<std::int32_t> bounds;  ///< surfaces that bound it
};

/// Curves, then surfaces, then volumes.
std::vector<MshEntity> mshEntities(const ModelMesh& mesh, Lines lines, const MshGroups& groups,
                                   const std::vector<MshVolume>& volumes);

/// The section $PhysicalNames: only of groups that some entity belongs to.
void writePhysicalNames(const std::vector<MshEntity>& entities, const MshGroups& groups,
                        OutputFile& file);

/// Gmsh's number for a kind of element.
std::int32_t mshType(const ModelMesh& mesh, bool isQuad);
std::int32_t mshLineType(const ModelMesh& mesh);

}  // namespace af2::geometry
