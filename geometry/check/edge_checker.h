// Looks at the edges of a mesh: how often, and in which directions, elements use them.
// Not installed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/check/element_checker.h"
#include "geometry/mesh/merged_patches.h"
#include "geometry/mesh/mesh_sides.h"

namespace af2::geometry {

/// How often a piece of a model edge is to be used. Several may have the same ends.
struct WantedUses {
  VertexId low, high;
  int uses = 0;
  auto key() const { return std::pair(low, high); }
};

/// Of all segments of a mesh, in the order of their keys.
std::vector<WantedUses> wantedUses(const ModelMesh& mesh);

/// Looks at the edges whose lower vertex is one of some.
class EdgeChecker {
 public:
  /// Data that all parts of the check use.
  struct Task {
    const ModelMesh& mesh;
    const std::vector<WantedUses>& wanted;
    std::vector<std::size_t> elements;  ///< whose edges are to be looked at
    std::uint32_t last;                 ///< edges that end at a vertex from here on are not
  };

  EdgeChecker(const Task& task, Findings findings)
      : mesh_(task.mesh), task_(task), findings_(std::move(findings)) {}

  Findings check(VertexRange range);

 private:
  std::vector<WantedUses>::const_iterator firstFrom(std::size_t vertex) const {
    return std::ranges::lower_bound(task_.wanted, VertexId(vertex), {}, &WantedUses::low);
  }
  const Point3& position(VertexId v) const { return mesh_.vertices[v.value]; }
  int faceOf(const MeshSide& side) const { return patches_.of(mesh_.face[side.element()]); }
  void addMissing(const WantedUses& segment);
  void checkSegment(const WantedUses& segment, std::span<const MeshSide> sides);
  void checkEdge(const Point3& place, std::span<const MeshSide> sides);

  const ModelMesh& mesh_;
  const MergedPatches patches_{mesh_};
  const Task& task_;
  Findings findings_;
};

/// Runs the task on all of its vertices.
void checkEdges(const EdgeChecker::Task& task, int threads, Findings& findings);

}  // namespace af2::geometry
