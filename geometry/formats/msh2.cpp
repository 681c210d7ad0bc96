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
  std::vector<bool> isUsed(mesh.vertices.size(), false);
  std::size_t count = 0;
  for (const MshEntity& entity : entities) {
    count += entity.vertices.size();
    for (const std::uint32_t vertex : entity.vertices) isUsed[vertex] = true;
  }
  putSection("Nodes", count, file);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!isUsed[v]) continue;
    file.number(v + 1);
    for (const double x : {mesh.vertices[v].x, mesh.vertices[v].y, mesh.vertices[v].z}) {
      file.text(" ");
      file.number(x);
    }
    file.text("\n");
  }
  file.text("$EndNodes\n");
}

void putElement(const MshEntity& entity, std::int32_t type, std::size_t number,
                const std::vector<VertexId>& vertices, OutputFile& file) {
  constexpr std::int32_t kTags = 2;  // physical group, entity
  file.number(number);
  for (const std::int32_t value : {type, kTags, entity.groups.front(), entity.id}) {
    file.text(" ");
    file.number(value);
  }
  for (const VertexId vertex : vertices) {
    file.text(" ");
    file.number(std::size_t{vertex.value} + 1);
  }
  file.text("\n");
}

/// Elements have the same numbers as in version 4.1.
void putElements(const ModelMesh& mesh, const std::vector<MshEntity>& entities, Lines lines,
                 OutputFile& file) {
  putSection("Elements", mesh.elements.size() + lines.size(), file);
  for (const MshEntity& entity : entities) {
    for (const std::uint32_t line : entity.lines)
      putElement(entity, mshLineType(mesh), mesh.elements.size() + 1 + line,
                 mshVertices(lines[line]), file);
    for (const auto* const elements : {&entity.triangles, &entity.quads})
      for (const std::uint32_t element : *elements)
        putElement(entity, mshType(mesh, elements == &entity.quads), element + 1u,
                   mshVertices(mesh, element), file);
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
