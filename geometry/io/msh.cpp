// Gmsh's format, version 4.1, binary. Each model face is a surface entity and, under its name, a
// physical group of the same number, so that boundary conditions can be given by face; and it
// belongs to the physical groups of the parts, solids, layers and colours of the model.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "geometry/io/formats.h"

namespace af2::geometry {
namespace {

constexpr std::int32_t kSurface = 2, kNoParameters = 0;

/// Gmsh's number for a kind of element.
std::int32_t typeOf(const ModelMesh& mesh, bool isQuad) {
  constexpr std::int32_t kTriangle = 2, kQuad = 3, kTriangle2 = 9, kQuad2 = 16;
  if (mesh.midsides.empty()) return isQuad ? kQuad : kTriangle;
  return isQuad ? kQuad2 : kTriangle2;
}

/// Corners, then middles of sides.
std::vector<VertexId> verticesOf(const ModelMesh& mesh, std::size_t element) {
  const auto corners = mesh.elements[element].vertices();
  std::vector<VertexId> vertices(corners.begin(), corners.end());
  for (std::size_t i = 0; !mesh.midsides.empty() && i < corners.size(); ++i)
    vertices.push_back(mesh.midsides[element][i]);
  return vertices;
}

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
  std::vector<std::int32_t> groups;  ///< physical groups: its own first
  Box box;
  std::vector<std::uint32_t> vertices;  ///< those that no earlier entity has
  std::vector<std::uint32_t> triangles, quads;
};

std::int32_t highestFace(const ModelMesh& mesh) {
  std::int32_t highest = 0;
  for (const FaceReport& face : mesh.faces) highest = std::max(highest, face.id);
  for (const FaceGroup& group : mesh.groups)
    for (const int face : group.faces) highest = std::max(highest, face);
  return highest;
}

/// Names of groups must differ and fit between quotation marks.
std::string uniqueName(std::string name, const std::string& what, std::set<std::string>& taken) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return c < ' ' || c == '"'; }, '_');
  constexpr std::size_t kLongest = 100;  // the format allows 127, with what follows
  if (name.size() > kLongest) {
    std::size_t end = kLongest;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;
    name.resize(end);  // between characters of UTF-8
  }
  const std::string plain = name;
  for (int count = 1; !taken.insert(name).second; ++count)
    name = plain + " (" + what + (count > 1 ? " " + std::to_string(count) : "") + ")";
  return name;
}

/// Physical groups by their number: one for each face, with its id; then those of the model.
std::map<std::int32_t, std::string> groupNames(const ModelMesh& mesh) {
  std::map<std::int32_t, std::string> names;
  std::set<std::string> taken;
  for (const FaceReport& face : mesh.faces)
    names[face.id] = uniqueName(face.name.empty() ? "face " + std::to_string(face.id) : face.name,
                                "face " + std::to_string(face.id), taken);
  const std::int32_t firstGroup = highestFace(mesh) + 1;
  for (std::size_t i = 0; i < mesh.groups.size(); ++i) {
    const FaceGroup& group = mesh.groups[i];
    const std::int32_t id = firstGroup + static_cast<std::int32_t>(i);
    const bool isNamed = group.kind == GroupKind::Part || group.kind == GroupKind::Layer;
    names[id] = uniqueName(isNamed ? group.name : toString(group.kind) + (" " + group.name),
                           toString(group.kind), taken);
  }
  return names;
}

std::vector<std::int32_t> groupsOf(const ModelMesh& mesh, std::int32_t face) {
  std::vector<std::int32_t> groups{face};
  const std::int32_t firstGroup = highestFace(mesh) + 1;
  for (std::size_t i = 0; i < mesh.groups.size(); ++i)
    if (std::ranges::binary_search(mesh.groups[i].faces, face))
      groups.push_back(firstGroup + static_cast<std::int32_t>(i));
  return groups;
}

std::vector<Entity> entitiesOf(const ModelMesh& mesh) {
  std::map<std::int32_t, Entity> byFace;
  std::vector<bool> placed(mesh.vertices.size(), false);
  for (std::uint32_t i = 0; i < mesh.elements.size(); ++i) {
    Entity& entity = byFace[mesh.face[i]];
    (mesh.elements[i].isQuad() ? entity.quads : entity.triangles).push_back(i);
    for (const VertexId vertex : verticesOf(mesh, i)) {
      entity.box.add(mesh.vertices[vertex.value]);
      if (!placed[vertex.value]) entity.vertices.push_back(vertex.value);
      placed[vertex.value] = true;
    }
  }
  std::vector<Entity> entities;
  for (auto& [face, entity] : byFace) {
    entity.face = face;
    entity.groups = groupsOf(mesh, face);
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

/// Only of groups that some element belongs to.
void writePhysicalNames(const ModelMesh& mesh, const std::vector<Entity>& entities,
                        OutputFile& file) {
  const std::map<std::int32_t, std::string> names = groupNames(mesh);
  std::set<std::int32_t> used;
  for (const Entity& entity : entities) used.insert(entity.groups.begin(), entity.groups.end());
  file.text("$PhysicalNames\n");
  file.number(used.size());
  for (const std::int32_t group : used) {
    const auto name = names.find(group);
    file.text("\n2 ");
    file.number(group);
    file.text(" \"");
    file.text(name == names.end() ? "face " + std::to_string(group) : name->second);
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
    file.binary(std::uint64_t{entity.groups.size()});
    for (const std::int32_t group : entity.groups) file.binary(group);
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
    for (const VertexId vertex : verticesOf(mesh, element)) {
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
    writeBlock(mesh, entity.face, typeOf(mesh, false), entity.triangles, file);
    writeBlock(mesh, entity.face, typeOf(mesh, true), entity.quads, file);
  }
  file.text("\n$EndElements\n");
}

}  // namespace

void writeMsh(const ModelMesh& mesh, OutputFile& file) {
  const std::vector<Entity> entities = entitiesOf(mesh);
  file.text("$MeshFormat\n4.1 1 8\n");
  file.binary(std::int32_t{1});  // tells readers the order of bytes
  file.text("\n$EndMeshFormat\n");
  writePhysicalNames(mesh, entities, file);
  writeEntities(entities, file);
  writeNodes(mesh, entities, file);
  writeElements(mesh, entities, file);
}

}  // namespace af2::geometry
