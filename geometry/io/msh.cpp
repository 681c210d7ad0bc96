// Gmsh's format, version 4.1, binary. Each model face is a surface entity and, under its name, a
// physical group of the same number, so that boundary conditions can be given by face; and it
// belongs to the physical groups of the parts, solids, layers and colours of the model. Each edge
// with line elements is a curve entity, in the physical group of its boundary or in one of its own.
// Each solid is a volume entity without elements, bounded by its faces.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "geometry/base/box_tree.h"
#include "geometry/io/formats.h"
#include "geometry/io/msh_groups.h"
#include "geometry/io/msh_volumes.h"

namespace af2::geometry {
namespace {

constexpr std::int32_t kCurve = PhysicalGroup::kCurve, kSurface = PhysicalGroup::kSurface,
                       kVolume = PhysicalGroup::kVolume;
constexpr std::int32_t kNoParameters = 0;

/// Gmsh's number for a kind of element.
std::int32_t typeOf(const ModelMesh& mesh, bool isQuad) {
  constexpr std::int32_t kTriangle = 2, kQuad = 3, kTriangle2 = 9, kQuad2 = 16;
  if (mesh.midsides.empty()) return isQuad ? kQuad : kTriangle;
  return isQuad ? kQuad2 : kTriangle2;
}

std::int32_t typeOfLine(const ModelMesh& mesh) {
  constexpr std::int32_t kLine = 1, kLine2 = 8;
  return mesh.midsides.empty() ? kLine : kLine2;
}

/// Corners, then middles of sides.
std::vector<VertexId> verticesOf(const ModelMesh& mesh, std::size_t element) {
  const auto corners = mesh.elements[element].vertices();
  std::vector<VertexId> vertices(corners.begin(), corners.end());
  for (std::size_t i = 0; !mesh.midsides.empty() && i < corners.size(); ++i)
    vertices.push_back(mesh.midsides[element][i]);
  return vertices;
}

/// Ends, then the middle.
std::vector<VertexId> verticesOf(const LineElement& line) {
  std::vector<VertexId> vertices{line.from, line.to};
  if (!line.middle.isNone()) vertices.push_back(line.middle);
  return vertices;
}

/// The mesh of one model edge or face; or a solid, which has none.
struct Entity {
  std::int32_t dimension = kSurface;
  std::int32_t id = 0;               ///< of the edge, face or solid
  std::vector<std::int32_t> groups;  ///< physical groups: of a face, its own first
  Box3 box;
  std::vector<std::uint32_t> vertices;  ///< those that no earlier entity has
  std::vector<std::uint32_t> lines, triangles, quads;
  std::vector<std::int32_t> bounds;  ///< surfaces that bound it
};

/// Takes what entities consist of; each vertex belongs to the first that comes to it.
class EntityMaker {
 public:
  explicit EntityMaker(const ModelMesh& mesh) : mesh_(mesh), placed_(mesh.vertices.size(), false) {}

  void take(const std::vector<VertexId>& vertices, Entity& entity) {
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
Entity entityOf(const MshVolume& volume, const std::vector<Entity>& others) {
  Entity entity;
  entity.dimension = kVolume;
  entity.id = volume.number;
  entity.groups = {volume.number};
  entity.bounds = volume.surfaces;
  for (const Entity& other : others)
    if (other.dimension == kSurface &&
        std::ranges::binary_search(volume.surfaces, other.id, {},
                                   [](auto id) { return id < 0 ? -id : id; }))
      entity.box.add(other.box);
  return entity;
}

/// Curves, then surfaces, then volumes.
std::vector<Entity> entitiesOf(const ModelMesh& mesh, Lines lines, const MshGroups& groups,
                               const std::vector<MshVolume>& volumes) {
  std::map<std::pair<std::int32_t, std::int32_t>, Entity> byDimensionAndId;
  EntityMaker maker(mesh);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    Entity& entity = byDimensionAndId[{kCurve, lines[i].edge}];
    entity.lines.push_back(i);
    entity.groups = {groups.of(lines[i])};
    maker.take(verticesOf(lines[i]), entity);
  }
  for (std::uint32_t i = 0; i < mesh.elements.size(); ++i) {
    Entity& entity = byDimensionAndId[{kSurface, mesh.face[i]}];
    (mesh.elements[i].isQuad() ? entity.quads : entity.triangles).push_back(i);
    maker.take(verticesOf(mesh, i), entity);
  }
  std::vector<Entity> entities;
  for (auto& [key, entity] : byDimensionAndId) {
    std::tie(entity.dimension, entity.id) = key;
    if (entity.dimension == kSurface) entity.groups = groups.ofFace(entity.id);
    std::ranges::sort(entity.vertices);
    entities.push_back(std::move(entity));
  }
  for (const MshVolume& volume : volumes) entities.push_back(entityOf(volume, entities));
  return entities;
}

void putPoint(OutputFile& file, const Point3& p) {
  file.binary(p.x);
  file.binary(p.y);
  file.binary(p.z);
}

void putHead(OutputFile& file, std::uint64_t blocks, std::uint64_t count,
             std::uint64_t highestTag) {
  file.binary(blocks);
  file.binary(count);
  file.binary(std::uint64_t{count > 0});
  file.binary(highestTag);
}

/// Only of groups that some entity belongs to.
void writePhysicalNames(const std::vector<Entity>& entities, const MshGroups& groups,
                        OutputFile& file) {
  const std::map<PhysicalGroup, std::string>& names = groups.names();
  std::set<PhysicalGroup> used;
  for (const Entity& entity : entities)
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

void writeEntities(const std::vector<Entity>& entities, OutputFile& file) {
  file.text("$Entities\n");
  for (const std::int32_t dimension : {0, kCurve, kSurface, kVolume})
    file.binary(
        static_cast<std::uint64_t>(std::ranges::count(entities, dimension, &Entity::dimension)));
  for (const Entity& entity : entities) {
    file.binary(entity.id);
    putPoint(file, entity.box.low);
    putPoint(file, entity.box.high);
    file.binary(std::uint64_t{entity.groups.size()});
    for (const std::int32_t group : entity.groups) file.binary(group);
    file.binary(std::uint64_t{entity.bounds.size()});
    for (const std::int32_t bound : entity.bounds) file.binary(bound);
  }
  file.text("\n$EndEntities\n");
}

void writeNodes(const ModelMesh& mesh, const std::vector<Entity>& entities, OutputFile& file) {
  std::uint64_t blocks = 0, count = 0;
  for (const Entity& entity : entities) {
    blocks += !entity.vertices.empty();
    count += entity.vertices.size();
  }
  file.text("$Nodes\n");
  putHead(file, blocks, count, mesh.vertices.size());
  for (const Entity& entity : entities) {
    if (entity.vertices.empty()) continue;
    for (const std::int32_t number : {entity.dimension, entity.id, kNoParameters})
      file.binary(number);
    file.binary(std::uint64_t{entity.vertices.size()});
    for (const std::uint32_t vertex : entity.vertices) file.binary(std::uint64_t{vertex} + 1);
    for (const std::uint32_t vertex : entity.vertices) putPoint(file, mesh.vertices[vertex]);
  }
  file.text("\n$EndNodes\n");
}

/// Elements of one kind; verticesOf(i) are those of number i among `elements`, which has the tag
/// first + i.
template <class VerticesOf>
void writeBlock(const Entity& entity, std::int32_t type, const std::vector<std::uint32_t>& elements,
                std::uint64_t first, VerticesOf verticesOf, OutputFile& file) {
  if (elements.empty()) return;
  for (const std::int32_t number : {entity.dimension, entity.id, type}) file.binary(number);
  file.binary(std::uint64_t{elements.size()});
  for (const std::uint32_t element : elements) {
    file.binary(first + element);
    for (const VertexId vertex : verticesOf(element)) file.binary(std::uint64_t{vertex.value} + 1);
  }
}

/// Lines have the numbers after those of the elements of the surface.
void writeElements(const ModelMesh& mesh, const std::vector<Entity>& entities, Lines lines,
                   OutputFile& file) {
  std::uint64_t blocks = 0;
  for (const Entity& entity : entities)
    blocks += !entity.lines.empty() + !entity.triangles.empty() + !entity.quads.empty();
  const std::uint64_t count = mesh.elements.size() + lines.size();
  file.text("$Elements\n");
  putHead(file, blocks, count, count);
  const auto ofElement = [&](std::uint32_t element) { return verticesOf(mesh, element); };
  const auto ofLine = [&](std::uint32_t line) { return verticesOf(lines[line]); };
  for (const Entity& entity : entities) {
    writeBlock(entity, typeOfLine(mesh), entity.lines, mesh.elements.size() + 1, ofLine, file);
    writeBlock(entity, typeOf(mesh, false), entity.triangles, 1, ofElement, file);
    writeBlock(entity, typeOf(mesh, true), entity.quads, 1, ofElement, file);
  }
  file.text("\n$EndElements\n");
}

}  // namespace

void writeMsh(const ModelMesh& mesh, Lines lines, OutputFile& file) {
  const std::vector<MshVolume> volumes = mshVolumes(mesh);
  const MshGroups groups(mesh, lines, volumes);
  const std::vector<Entity> entities = entitiesOf(mesh, lines, groups, volumes);
  file.text("$MeshFormat\n4.1 1 8\n");
  file.binary(std::int32_t{1});  // tells readers the order of bytes
  file.text("\n$EndMeshFormat\n");
  writePhysicalNames(entities, groups, file);
  writeEntities(entities, file);
  writeNodes(mesh, entities, file);
  writeElements(mesh, entities, lines, file);
}

}  // namespace af2::geometry
