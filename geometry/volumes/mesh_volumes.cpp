#include "geometry/volumes/mesh_volumes.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/mesh/triangles_of.h"
#include "geometry/volumes/mesh_cells.h"

namespace af2::geometry {
namespace {

/// The cells on both sides of a model face: [0] before it, where the normals of its elements point
/// to, [1] behind it.
using CellsAtFace = std::array<std::set<std::uint32_t>, 2>;

/// By id of the face.
std::map<int, CellsAtFace> cellsAtFaces(const MeshCells& cells, const std::vector<int>& faces) {
  std::map<int, CellsAtFace> atFaces;
  std::array<std::uint32_t, 2> last{};
  for (std::size_t t = 0; t < faces.size(); ++t) {
    const std::array now{cells.ofSide[2 * t], cells.ofSide[2 * t + 1]};
    if (t > 0 && faces[t] == faces[t - 1] && now == last) continue;
    last = now;
    if (now[0] == now[1]) continue;  // it bounds nothing
    CellsAtFace& at = atFaces[faces[t]];
    for (const std::size_t side : {0u, 1u}) at[side].insert(now[side]);
  }
  return atFaces;
}

/// Whose material each cell is.
class Materials {
 public:
  Materials(const ModelMesh& mesh, const std::map<int, CellsAtFace>& atFaces, std::size_t cells)
      : atFaces_(atFaces), solidOf_(cells, 0) {
    std::set<int> ofNoSolid;
    for (const auto& [face, at] : atFaces) ofNoSolid.insert(face);
    int solids = 0;
    for (const FaceGroup& group : mesh.groups) {
      if (group.kind != GroupKind::Solid) continue;
      give(++solids, withoutCavities(group, cellsOf(group)));
      for (const int face : group.faces) ofNoSolid.erase(face);
    }
    const FaceGroup others{.name = "", .faces = {ofNoSolid.begin(), ofNoSolid.end()}};
    for (const std::uint32_t cell : cellsOf(others))
      if (solidOf_[cell] == 0) solidOf_[cell] = ++solids;
  }

  int solidOf(std::uint32_t cell) const { return solidOf_[cell]; }

 private:
  /// Bounded cells behind the faces of a solid. If there are none although each face bounds
  /// something, the solid is inside out.
  std::set<std::uint32_t> cellsOf(const FaceGroup& solid) const {
    std::set<std::uint32_t> cells = cellsOn(solid, 1);
    const auto isBoundary = [&](int face) { return atFaces_.contains(face); };
    if (cells.empty() && std::ranges::all_of(solid.faces, isBoundary)) return cellsOn(solid, 0);
    return cells;
  }

  /// Leaves out those that the material of the solid itself surrounds: they are cavities whose
  /// faces look the wrong way, as some files have them.
  std::set<std::uint32_t> withoutCavities(const FaceGroup& solid,
                                          std::set<std::uint32_t> cells) const {
    std::set<std::uint32_t> surrounded = cells;
    for (const auto& [face, at] : atFaces_) {
      const bool isOfSolid = std::ranges::binary_search(solid.faces, face);
      for (const std::size_t side : {0u, 1u}) {
        if (isOfSolid && std::ranges::includes(cells, at[1 - side])) continue;
        for (const std::uint32_t cell : at[side]) surrounded.erase(cell);
      }
    }
    for (const std::uint32_t cavity : surrounded) cells.erase(cavity);
    return cells;
  }

  std::set<std::uint32_t> cellsOn(const FaceGroup& solid, std::size_t side) const {
    std::set<std::uint32_t> cells;
    for (const int face : solid.faces) {
      const auto at = atFaces_.find(face);
      if (at == atFaces_.end()) continue;
      const bool isInward = std::ranges::binary_search(solid.inward, face);
      const auto& there = at->second[isInward ? 1 - side : side];
      cells.insert(there.begin(), there.end());
    }
    cells.erase(MeshCells::kOutside);
    return cells;
  }

  void give(int solid, const std::set<std::uint32_t>& cells) {
    for (const std::uint32_t cell : cells)
      if (solidOf_[cell] == 0) solidOf_[cell] = solid;
  }

  const std::map<int, CellsAtFace>& atFaces_;
  std::vector<int> solidOf_;  ///< by cell; 0: a void
};

}  // namespace

std::vector<MeshVolume> volumesOf(const ModelMesh& mesh, PointsInside points) {
  std::vector<Triangle> triangles;
  std::vector<int> faces;  // by triangle
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const Triangle& triangle : trianglesOf(mesh, mesh.elements[e])) {
      triangles.push_back(triangle);
      faces.push_back(mesh.face[e]);
    }
  const MeshCells cells = cellsOf(mesh.vertices, triangles, points);
  const std::map<int, CellsAtFace> atFaces = cellsAtFaces(cells, faces);
  const Materials materials(mesh, atFaces, cells.inside.size());

  std::vector<MeshVolume> volumes(cells.inside.size());
  for (const auto& [face, at] : atFaces)
    for (const auto& side : at)
      for (const std::uint32_t cell : side)
        if (volumes[cell].faces.empty() || volumes[cell].faces.back() != face)
          volumes[cell].faces.push_back(face);
  std::vector<MeshVolume> found;
  for (std::uint32_t cell = 1; cell < volumes.size(); ++cell) {
    if (points == PointsInside::Wanted && !cells.inside[cell]) continue;
    volumes[cell].solid = materials.solidOf(cell);
    volumes[cell].inside = cells.inside[cell].value_or(Point3{});
    found.push_back(std::move(volumes[cell]));
  }
  return found;
}

}  // namespace af2::geometry
