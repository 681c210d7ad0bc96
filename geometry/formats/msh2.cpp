// Gmsh's format, version 2.2, as text, for programs that read no later one. An element has one
// physical group, and entities of the model are but numbers.
#include "geometry/formats/msh_entities.h"
#include "geometry/io/formats.h"

namespace af2::geometry {
namespace {

void putSection(const char* name, std::size_t count, OutputFile& file) {
  file.text("$");
  file.text(name);
  file.text("\n");
  file.number(count);
  file.text("\n");
}

void putNodes(const ModelMesh& mesh, const std::vector<MshEntity>& entities, OutputFile& file) {
  std::vector<bool> isUsed(vertexCount(mesh), false);
  std::size_t count = 0;
  for (const MshEntity& entity : entities) {
    count += entity.vertices.size();
    entity.vertices.forEach([&](std::uint32_t vertex) { isUsed[vertex] = true; });
  }
  putSection("Nodes", count, file);
  forEachSlice(mesh, [&](const MeshSlice& slice) {
    for (std::size_t i = 0; i < slice.vertices.size(); ++i) {
      if (!isUsed[slice.firstVertex + i]) continue;
      file.number(slice.firstVertex + i + 1);
      for (const double x : {slice.vertices[i].x, slice.vertices[i].y, slice.vertices[i].z}) {
        file.text(" ");
        file.number(x);
      }
      file.text("\n");
    }
  });
  file.text("$EndNodes\n");
}

/// What precedes the vertices of an element.
void putHead(const MshEntity& entity, std::int32_t type, std::size_t number, OutputFile& file) {
  constexpr std::int32_t kTags = 2;  // physical group, entity
  file.number(number);
  for (const std::int32_t value : {type, kTags, entity.groups.front(), entity.id}) {
    file.text(" ");
    file.number(value);
  }
}

void putVertex(VertexId vertex, OutputFile& file) {
  file.text(" ");
  file.number(std::size_t{vertex.value} + 1);
}

/// Elements have the same numbers as in version 4.1.
void putElements(const ModelMesh& mesh, const std::vector<MshEntity>& entities, Lines lines,
                 OutputFile& file) {
  putSection("Elements", elementCount(mesh) + lines.size(), file);
  for (const MshEntity& entity : entities) {
    for (const std::uint32_t line : entity.lines) {
      putHead(entity, mshLineType(mesh), elementCount(mesh) + 1 + line, file);
      for (const VertexId vertex : mshVertices(lines[line])) putVertex(vertex, file);
      file.text("\n");
    }
    for (const bool isQuad : {false, true})
      forEachOfKind(mesh, entity, isQuad, [&](const MeshSlice& slice, std::size_t i) {
        putHead(entity, mshType(mesh, isQuad), slice.firstElement + i + 1, file);
        forEachMshVertex(mesh, slice, i, [&](VertexId vertex) { putVertex(vertex, file); });
        file.text("\n");
      });
  }
  file.text("$EndElements\n");
}

}  // namespace

void writeMsh2(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  static constexpr std::array kByFace{Grouping::Faces};
  const Extras disjoint{extras.lines,
                        extras.groups.empty() ? std::span<const Grouping>(kByFace) : extras.groups};
  const MshGroups groups(mesh, disjoint, {});
  const std::vector<MshEntity> entities = mshEntities(mesh, extras.lines, groups, {});
  file.text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
  writePhysicalNames(entities, groups, file);
  putNodes(mesh, entities, file);
  putElements(mesh, entities, extras.lines, file);
}

}  // namespace af2::geometry
