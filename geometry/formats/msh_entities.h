// A mesh as Gmsh's formats see it: by entities of the model, with their physical groups.
// Not installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/base/box_tree.h"
#include "geometry/formats/element_vertices.h"
#include "geometry/formats/msh_groups.h"
#include "geometry/formats/msh_volumes.h"

namespace af2::geometry {

/// Ids in a row.
struct IdRange {
  std::uint32_t first = 0, last = 0;  ///< the last is excluded
};

/// Ascending ids. Those of a face are few ranges, which take less memory than the ids.
class IdRanges {
 public:
  /// Adds ids in any order; none that was added before.
  void add(std::vector<std::uint32_t> ids);

  bool empty() const { return ranges_.empty(); }
  std::size_t size() const;
  const std::vector<IdRange>& ranges() const { return ranges_; }
  template <class Visit>
  void forEach(const Visit& visit) const {
    for (const IdRange& range : ranges_)
      for (std::uint32_t id = range.first; id < range.last; ++id) visit(id);
  }

 private:
  std::vector<IdRange> ranges_;
};

/// The mesh of one model edge or face; or a solid, which has none.
struct MshEntity {
  std::int32_t dimension = PhysicalGroup::kSurface;
  std::int32_t id = 0;               ///< of the edge, face or solid
  std::vector<std::int32_t> groups;  ///< physical groups: of a face, its own first
  Box3 box;
  IdRanges vertices;  ///< those that no earlier entity has
  std::vector<std::uint32_t> lines;
  std::vector<FaceElements> elements;
  std::size_t triangles = 0, quads = 0;
  std::vector<std::int32_t> bounds;  ///< surfaces that bound it
};

/// Calls visit(slice, i) for each triangle of an entity, or for each quadrilateral.
template <class Visit>
void forEachOfKind(const ModelMesh& mesh, const MshEntity& entity, bool isQuad,
                   const Visit& visit) {
  if ((isQuad ? entity.quads : entity.triangles) == 0) return;
  for (const FaceElements& some : entity.elements)
    forEachElementOf(mesh, some, [&](const MeshSlice& slice, std::size_t i) {
      if (slice.elements[i].isQuad() == isQuad) visit(slice, i);
    });
}

/// Calls visit(id, point) for each vertex of an entity, ascending.
void forEachVertexOf(const ModelMesh& mesh, const MshEntity& entity,
                     const std::function<void(std::uint32_t, const Point3&)>& visit);

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
