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
  explicit EntityMaker(const ModelMesh& mesh) : mesh_(mesh), placed_(vertexCount(mesh), false) {}

  void take(const LineElement& line, MshEntity& entity) {
    std::vector<std::uint32_t> added;
    for (const VertexId vertex : mshVertices(line))
      take(vertex, mesh_.vertices[vertex.value], entity, added);
    entity.vertices.add(std::move(added));
  }

  void take(const FaceElements& some, MshEntity& entity) {
    std::vector<std::uint32_t> added;
    forEachElementOf(mesh_, some, [&](const MeshSlice& slice, std::size_t i) {
      const Element& element = slice.elements[i];
      ++(element.isQuad() ? entity.quads : entity.triangles);
      forEachMshVertex(mesh_, slice, i, [&](VertexId vertex) {
        take(vertex, slice.position(vertex), entity, added);
      });
    });
    entity.elements.push_back(some);
    entity.vertices.add(std::move(added));
  }

 private:
  void take(VertexId vertex, const Point3& place, MshEntity& entity,
            std::vector<std::uint32_t>& added) {
    entity.box.add(place);
    if (!placed_[vertex.value]) added.push_back(vertex.value);
    placed_[vertex.value] = true;
  }

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

void IdRanges::add(std::vector<std::uint32_t> ids) {
  if (ids.empty()) return;
  std::ranges::sort(ids);
  for (const std::uint32_t id : ids)
    if (!ranges_.empty() && ranges_.back().last == id)
      ++ranges_.back().last;
    else
      ranges_.push_back({id, id + 1});
  std::ranges::sort(ranges_, {}, &IdRange::first);
}

std::size_t IdRanges::size() const {
  std::size_t size = 0;
  for (const IdRange& range : ranges_) size += range.last - range.first;
  return size;
}

void forEachVertexOf(const ModelMesh& mesh, const MshEntity& entity,
                     const std::function<void(std::uint32_t, const Point3&)>& visit) {
  const auto visitIn = [&](const MeshSlice& slice) {
    entity.vertices.forEach([&](std::uint32_t id) { visit(id, slice.position(VertexId(id))); });
  };
  if (!entity.elements.empty()) return visitSliceOf(mesh, entity.elements.front().first, visitIn);
  MeshSlice onEdges;  // lines have no others
  onEdges.vertices = mesh.vertices;
  visitIn(onEdges);
}

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
    maker.take(lines[i], entity);
  }
  for (const FaceElements& some : elementsByFace(mesh))
    maker.take(some, byDimensionAndId[{PhysicalGroup::kSurface, some.face}]);
  std::vector<MshEntity> entities;
  for (auto& [key, entity] : byDimensionAndId) {
    std::tie(entity.dimension, entity.id) = key;
    if (entity.dimension == PhysicalGroup::kSurface) entity.groups = groups.ofFace(entity.id);
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
