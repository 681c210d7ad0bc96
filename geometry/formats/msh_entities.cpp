#include "geometry/formats/msh_entities.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace af2::geometry {
namespace {

/// Takes what entities consist of; each vertex belongs to the first that comes to it.
class EntityMaker {
 public:
  explicit EntityMaker(const ModelMesh& mesh) : mesh_(mesh), placed_(mesh.vertices.size(), false) {}

  void take(const std::vector<VertexId>& vertices, MshEntity& entity) {
    for (const VertexId vertex : vertices) {
      entity.box.add(mesh_.vertices[vertex.value]);
      if (!placed_[vertex.value]) entity.vertices.push_back(vertex.value);
      placed_[vertex.value] = true;
    }
  }

 private:
  const ModelMesh& mesh_;
  std::vector<bool> placed_;
};

/// `others` are the entities of lower dimension.
MshEntity entityOf(const MshVolume& volume, const std::vector<MshEntity>& others) {
  MshEntity entity;
  entity.dimension = PhysicalGroup::kVolume;
  entity.id = volume.number;
  entity.groups = {volume.number};
  entity.bounds = volume.surfaces;
  for (const MshEntity& other : others)
    if (other.dimension == PhysicalGroup::kSurface &&
        std::ranges::binary_search(volume.surfaces, other.id, {},
                                   [](auto id) { return id < 0 ? -id : id; }))
      entity.box.add(other.box);
  return entity;
}

}  // namespace

std::int32_t mshType(const ModelMesh& mesh, bool isQuad) {
  constexpr std::int32_t kTriangle = 2, kQuad = 3, kTriangle2 = 9, kQuad2 = 16;
  if (mesh.midsides.empty()) return isQuad ? kQuad : kTriangle;
  return isQuad ? kQuad2 : kTriangle2;
}

std::int32_t mshLineType(const ModelMesh& mesh) {
  constexpr std::int32_t kLine = 1, kLine2 = 8;
  return mesh.midsides.empty() ? kLine : kLine2;
}

std::vector<MshEntity> mshEntities(const ModelMesh& mesh, Lines lines, const MshGroups& groups,
                                   const std::vector<MshVolume>& volumes) {
  std::map<std::pair<std::int32_t, std::int32_t>, MshEntity> byDimensionAndId;
  EntityMaker maker(mesh);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    MshEntity& entity = byDimensionAndId[{PhysicalGroup::kCurve, lines[i].edge}];
    entity.lines.push_back(i);
    entity.groups = {groups.of(lines[i])};
    maker.take(mshVertices(lines[i]), entity);
  }
  for (std::uint32_t i = 0; i < mesh.elements.size(); ++i) {
    MshEntity& entity = byDimensionAndId[{PhysicalGroup::kSurface, mesh.face[i]}];
    (mesh.elements[i].isQuad() ? entity.quads : entity.triangles).push_back(i);
    maker.take(mshVertices(mesh, i), entity);
  }
  std::vector<MshEntity> entities;
  for (auto& [key, entity] : byDimensionAndId) {
    std::tie(entity.dimension, entity.id) = key;
    if (entity.dimension == PhysicalGroup::kSurface) entity.groups = groups.ofFace(entity.id);
    std::ranges::sort(entity.vertices);
    entities.push_back(std::move(entity));
  }
  for (const MshVolume& volume : volumes) entities.push_back(entityOf(volume, entities));
  return entities;
}

void writePhysicalNames(const std::vector<MshEntity>& entities, const MshGroups& groups,
                        OutputFile& file) {
  const std::map<PhysicalGroup, std::string>& names = groups.names();
  std::set<PhysicalGroup> used;
  for (const MshEntity& entity : entities)
    for (const std::int32_t group : entity.groups) used.insert({entity.dimension, group});
  file.text("$PhysicalNames\n");
  file.number(used.size());
  for (const PhysicalGroup& group : used) {
    const auto name = names.find(group);
    file.text("\n");
    file.number(group.dimension);
    file.text(" ");
    file.number(group.number);
    file.text(" \"");
    file.text(name == names.end() ? "face " + std::to_string(group.number) : name->second);
    file.text("\"");
  }
  file.text("\n$EndPhysicalNames\n");
}

}  // namespace af2::geometry
