// Gmsh's format, version 4.1, binary. Each model face is a surface entity and, under its name, a
// physical group of the same number, so that boundary conditions can be given by face; and it
// belongs to the physical groups of the parts, solids, layers and colours of the model. Each edge
// with line elements is a curve entity, in the physical group of its boundary or in one of its own.
// Each solid is a volume entity without elements, bounded by its faces.
#include <algorithm>

#include "geometry/formats/msh_entities.h"
#include "geometry/formats/msh_periodic.h"
#include "geometry/io/formats.h"

namespace af2::geometry {
namespace {

constexpr std::int32_t kCurve = PhysicalGroup::kCurve, kSurface = PhysicalGroup::kSurface,
                       kVolume = PhysicalGroup::kVolume;
constexpr std::int32_t kNoParameters = 0;

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

void writeEntities(const std::vector<MshEntity>& entities, OutputFile& file) {
  file.text("$Entities\n");
  for (const std::int32_t dimension : {0, kCurve, kSurface, kVolume})
    file.binary(
        static_cast<std::uint64_t>(std::ranges::count(entities, dimension, &MshEntity::dimension)));
  for (const MshEntity& entity : entities) {
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

void writeNodes(const ModelMesh& mesh, const std::vector<MshEntity>& entities, OutputFile& file) {
  std::uint64_t blocks = 0, count = 0;
  for (const MshEntity& entity : entities) {
    blocks += !entity.vertices.empty();
    count += entity.vertices.size();
  }
  file.text("$Nodes\n");
  putHead(file, blocks, count, mesh.vertices.size());
  for (const MshEntity& entity : entities) {
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
void writeBlock(const MshEntity& entity, std::int32_t type,
                const std::vector<std::uint32_t>& elements, std::uint64_t first,
                VerticesOf verticesOf, OutputFile& file) {
  if (elements.empty()) return;
  for (const std::int32_t number : {entity.dimension, entity.id, type}) file.binary(number);
  file.binary(std::uint64_t{elements.size()});
  for (const std::uint32_t element : elements) {
    file.binary(first + element);
    for (const VertexId vertex : verticesOf(element)) file.binary(std::uint64_t{vertex.value} + 1);
  }
}

/// Lines have the numbers after those of the elements of the surface.
void writeElements(const ModelMesh& mesh, const std::vector<MshEntity>& entities, Lines lines,
                   OutputFile& file) {
  std::uint64_t blocks = 0;
  for (const MshEntity& entity : entities)
    blocks += !entity.lines.empty() + !entity.triangles.empty() + !entity.quads.empty();
  const std::uint64_t count = mesh.elements.size() + lines.size();
  file.text("$Elements\n");
  putHead(file, blocks, count, count);
  const auto ofElement = [&](std::uint32_t element) { return mshVertices(mesh, element); };
  const auto ofLine = [&](std::uint32_t line) { return mshVertices(lines[line]); };
  for (const MshEntity& entity : entities) {
    writeBlock(entity, mshLineType(mesh), entity.lines, mesh.elements.size() + 1, ofLine, file);
    writeBlock(entity, mshType(mesh, false), entity.triangles, 1, ofElement, file);
    writeBlock(entity, mshType(mesh, true), entity.quads, 1, ofElement, file);
  }
  file.text("\n$EndElements\n");
}

}  // namespace

void writeMsh(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  const Lines lines = extras.lines;
  const std::vector<MshVolume> volumes = mshVolumes(mesh);
  const MshGroups groups(mesh, extras, volumes);
  const std::vector<MshEntity> entities = mshEntities(mesh, lines, groups, volumes);
  file.text("$MeshFormat\n4.1 1 8\n");
  file.binary(std::int32_t{1});  // tells readers the order of bytes
  file.text("\n$EndMeshFormat\n");
  writePhysicalNames(entities, groups, file);
  writeEntities(entities, file);
  writeNodes(mesh, entities, file);
  writeElements(mesh, entities, lines, file);
  writeMshPeriodic(mesh, file);
}

}  // namespace af2::geometry
