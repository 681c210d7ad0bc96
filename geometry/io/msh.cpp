// Gmsh's format, version 4.1, binary. Each model face is a surface entity and, under its name, a
// physical group of the same number, so that boundary conditions can be given by face.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "geometry/io/formats.h"

namespace af2::geometry {
namespace {

constexpr std::int32_t kSurface = 2, kGmshTriangle = 2, kGmshQuad = 3, kNoParameters = 0;

struct Box {
  Point3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void add(const Point3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

/// The mesh of one model face.
struct Entity {
  std::int32_t face = 0;
  std::string name;
  Box box;
  std::vector<std::uint32_t> vertices;  ///< those that no earlier entity has
  std::vector<std::uint32_t> triangles, quads;
};

/// Names of groups must differ and fit between quotation marks.
std::string groupName(const FaceReport& face, std::set<std::string>& taken) {
  std::string name = face.name.empty() ? "face " + std::to_string(face.id) : face.name;
  std::ranges::replace_if(
      name, [](unsigned char c) { return c < ' ' || c == '"'; }, '_');
  name.resize(std::min<std::size_t>(name.size(), 100));  // the format allows 127
  if (!taken.insert(name).second) {
    name += " (face " + std::to_string(face.id) + ")";
    taken.insert(name);
  }
  return name;
}

std::map<std::int32_t, std::string> groupNames(const ModelMesh& mesh) {
  std::map<std::int32_t, std::string> names;
  std::set<std::string> taken;
  for (const FaceReport& face : mesh.faces) names[face.id] = groupName(face, taken);
  return names;
}

std::vector<Entity> entitiesOf(const ModelMesh& mesh) {
  std::map<std::int32_t, Entity> byFace;
  std::vector<bool> placed(mesh.vertices.size(), false);
  for (std::uint32_t i = 0; i < mesh.elements.size(); ++i) {
    Entity& entity = byFace[mesh.face[i]];
    (mesh.elements[i].isQuad() ? entity.quads : entity.triangles).push_back(i);
    for (const VertexId vertex : mesh.elements[i].vertices()) {
      entity.box.add(mesh.vertices[vertex.value]);
      if (!placed[vertex.value]) entity.vertices.push_back(vertex.value);
      placed[vertex.value] = true;
    }
  }
  const std::map<std::int32_t, std::string> names = groupNames(mesh);
  std::vector<Entity> entities;
  for (auto& [face, entity] : byFace) {
    entity.face = face;
    const auto name = names.find(face);
    entity.name = name == names.end() ? "face " + std::to_string(face) : name->second;
    std::ranges::sort(entity.vertices);
    entities.push_back(std::move(entity));
  }
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

void writePhysicalNames(const std::vector<Entity>& entities, OutputFile& file) {
  file.text("$PhysicalNames\n");
  file.number(entities.size());
  for (const Entity& entity : entities) {
    file.text("\n2 ");
    file.number(entity.face);
    file.text(" \"");
    file.text(entity.name);
    file.text("\"");
  }
  file.text("\n$EndPhysicalNames\n");
}

void writeEntities(const std::vector<Entity>& entities, OutputFile& file) {
  file.text("$Entities\n");
  for (const std::uint64_t count :
       {std::size_t{0}, std::size_t{0}, entities.size(), std::size_t{0}}) {
    file.binary(count);
  }
  for (const Entity& entity : entities) {
    file.binary(entity.face);
    putPoint(file, entity.box.low);
    putPoint(file, entity.box.high);
    file.binary(std::uint64_t{1});
    file.binary(entity.face);       // the physical group
    file.binary(std::uint64_t{0});  // bounding curves
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
    for (const std::int32_t number : {kSurface, entity.face, kNoParameters}) file.binary(number);
    file.binary(std::uint64_t{entity.vertices.size()});
    for (const std::uint32_t vertex : entity.vertices) file.binary(std::uint64_t{vertex} + 1);
    for (const std::uint32_t vertex : entity.vertices) putPoint(file, mesh.vertices[vertex]);
  }
  file.text("\n$EndNodes\n");
}

void writeBlock(const ModelMesh& mesh, std::int32_t face, std::int32_t type,
                const std::vector<std::uint32_t>& elements, OutputFile& file) {
  if (elements.empty()) return;
  for (const std::int32_t number : {kSurface, face, type}) file.binary(number);
  file.binary(std::uint64_t{elements.size()});
  for (const std::uint32_t element : elements) {
    file.binary(std::uint64_t{element} + 1);
    for (const VertexId vertex : mesh.elements[element].vertices()) {
      file.binary(std::uint64_t{vertex.value} + 1);
    }
  }
}

void writeElements(const ModelMesh& mesh, const std::vector<Entity>& entities, OutputFile& file) {
  std::uint64_t blocks = 0;
  for (const Entity& entity : entities) blocks += !entity.triangles.empty() + !entity.quads.empty();
  file.text("$Elements\n");
  putHead(file, blocks, mesh.elements.size(), mesh.elements.size());
  for (const Entity& entity : entities) {
    writeBlock(mesh, entity.face, kGmshTriangle, entity.triangles, file);
    writeBlock(mesh, entity.face, kGmshQuad, entity.quads, file);
  }
  file.text("\n$EndElements\n");
}

}  // namespace

void writeMsh(const ModelMesh& mesh, OutputFile& file) {
  const std::vector<Entity> entities = entitiesOf(mesh);
  file.text("$MeshFormat\n4.1 1 8\n");
  file.binary(std::int32_t{1});  // tells readers the order of bytes
  file.text("\n$EndMeshFormat\n");
  writePhysicalNames(entities, file);
  writeEntities(entities, file);
  writeNodes(mesh, entities, file);
  writeElements(mesh, entities, file);
}

}  // namespace af2::geometry
