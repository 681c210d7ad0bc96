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
  putHead(file, blocks, count, vertexCount(mesh));
  for (const MshEntity& entity : entities) {
    if (entity.vertices.empty()) continue;
    for (const std::int32_t number : {entity.dimension, entity.id, kNoParameters})
      file.binary(number);
    file.binary(std::uint64_t{entity.vertices.size()});
    entity.vertices.forEach([&](std::uint32_t vertex) { file.binary(std::uint64_t{vertex} + 1); });
    forEachVertexOf(mesh, entity,
                    [&](std::uint32_t, const Point3& place) { putPoint(file, place); });
  }
  file.text("\n$EndNodes\n");
}

void putBlockHead(const MshEntity& entity, std::int32_t type, std::size_t count, OutputFile& file) {
  for (const std::int32_t number : {entity.dimension, entity.id, type}) file.binary(number);
  file.binary(std::uint64_t{count});
}

void putTag(VertexId vertex, OutputFile& file) { file.binary(std::uint64_t{vertex.value} + 1); }

/// Lines have the tags after those of the elements of the surface.
void writeLines(const ModelMesh& mesh, const MshEntity& entity, Lines lines, OutputFile& file) {
  if (entity.lines.empty()) return;
  putBlockHead(entity, mshLineType(mesh), entity.lines.size(), file);
  for (const std::uint32_t line : entity.lines) {
    file.binary(std::uint64_t{elementCount(mesh) + 1 + line});
    for (const VertexId vertex : mshVertices(lines[line])) putTag(vertex, file);
  }
}

void writeBlock(const ModelMesh& mesh, const MshEntity& entity, bool isQuad, OutputFile& file) {
  const std::size_t count = isQuad ? entity.quads : entity.triangles;
  if (count == 0) return;
  putBlockHead(entity, mshType(mesh, isQuad), count, file);
  forEachOfKind(mesh, entity, isQuad, [&](const MeshSlice& slice, std::size_t i) {
    file.binary(std::uint64_t{slice.firstElement + i + 1});
    forEachMshVertex(mesh, slice, i, [&](VertexId vertex) { putTag(vertex, file); });
  });
}

void writeElements(const ModelMesh& mesh, const std::vector<MshEntity>& entities, Lines lines,
                   OutputFile& file) {
  std::uint64_t blocks = 0;
  for (const MshEntity& entity : entities)
    blocks += !entity.lines.empty() + (entity.triangles > 0) + (entity.quads > 0);
  const std::uint64_t count = elementCount(mesh) + lines.size();
  file.text("$Elements\n");
  putHead(file, blocks, count, count);
  for (const MshEntity& entity : entities) {
    writeLines(mesh, entity, lines, file);
    for (const bool isQuad : {false, true}) writeBlock(mesh, entity, isQuad, file);
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
