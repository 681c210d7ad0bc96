#include "geometry/formats/msh_volumes.h"

#include <algorithm>
#include <map>
#include <set>

#include "geometry/volumes/mesh_volumes.h"

namespace af2::geometry {
namespace {

std::string nameOf(const ModelMesh& mesh, const FaceGroup& solid) {
  for (const FaceGroup& group : mesh.groups)
    if (group.kind == GroupKind::Part && group.faces == solid.faces) return group.name;
  return "solid " + solid.name;
}

}  // namespace

std::vector<MshVolume> mshVolumes(const ModelMesh& mesh) {
  // A solid may consist of several volumes, and the format has no surface twice in one entity.
  std::map<int, std::set<int>> facesOf;  // by solid
  for (const MeshVolume& volume : volumesOf(mesh, PointsInside::NotNeeded))
    if (volume.solid != 0) facesOf[volume.solid].insert(volume.faces.begin(), volume.faces.end());

  std::vector<const FaceGroup*> solids;
  for (const FaceGroup& group : mesh.groups)
    if (group.kind == GroupKind::Solid) solids.push_back(&group);

  std::vector<MshVolume> volumes;
  for (const auto& [number, faces] : facesOf) {
    const auto index = static_cast<std::size_t>(number) - 1;
    const FaceGroup* const solid = index < solids.size() ? solids[index] : nullptr;
    MshVolume& volume = volumes.emplace_back();
    volume.number = number;
    volume.name = solid ? nameOf(mesh, *solid) : "volume " + std::to_string(number);
    for (const int face : faces) {
      const bool looksIn = solid && std::ranges::binary_search(solid->inward, face);
      volume.surfaces.push_back(looksIn ? -face : face);
    }
  }
  return volumes;
}

}  // namespace af2::geometry
