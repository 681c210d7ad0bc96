// TetGen's .smesh: a closed surface, from which `tetgen -pq` makes tetrahedra. Each model face is a
// boundary marker, each solid a region, and each void a hole.
#include <algorithm>

#include "geometry/io/formats.h"
#include "geometry/mesh/triangles_of.h"
#include "geometry/volumes/mesh_volumes.h"

namespace af2::geometry {
namespace {

void putRow(OutputFile& file, std::size_t first, std::initializer_list<std::size_t> others) {
  file.number(first);
  for (const std::size_t number : others) {
    file.text(" ");
    file.number(number);
  }
  file.text("\n");
}

void putPoint(OutputFile& file, std::size_t number, const Point3& point) {
  file.number(number);
  for (const double x : {point.x, point.y, point.z}) {
    file.text(" ");
    file.number(x);
  }
}

/// Points in voids, from which TetGen takes the tetrahedra away; then points in solids, with the
/// attribute that `tetgen -A` gives to their tetrahedra.
void putHolesAndRegions(const std::vector<MeshVolume>& volumes, OutputFile& file) {
  const auto holes = static_cast<std::size_t>(std::ranges::count(volumes, 0, &MeshVolume::solid));
  putRow(file, holes, {});
  std::size_t number = 0;
  for (const MeshVolume& volume : volumes) {
    if (volume.solid != 0) continue;
    putPoint(file, ++number, volume.inside);
    file.text("\n");
  }
  putRow(file, volumes.size() - holes, {});
  number = 0;
  for (const MeshVolume& volume : volumes) {
    if (volume.solid == 0) continue;
    putPoint(file, ++number, volume.inside);
    file.text(" ");
    file.number(volume.solid);
    file.text(" -1\n");  // no largest volume of tetrahedra; left out, it would be the attribute
  }
}

}  // namespace

void writeSmesh(const ModelMesh& mesh, const Extras&, OutputFile& file) {
  putRow(file, cornerVertices(mesh).size(), {3, 0, 0});
  for (std::size_t v = 0; v < cornerVertices(mesh).size(); ++v) {
    putPoint(file, v + 1, mesh.vertices[v]);
    file.text("\n");
  }
  std::size_t triangles = 0;
  for (const Element& element : mesh.elements) triangles += element.isQuad() ? 2 : 1;
  putRow(file, triangles, {1});
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const auto& [a, b, c] : trianglesOf(mesh, mesh.elements[e]))
      putRow(file, 3,
             {a.value + 1u, b.value + 1u, c.value + 1u, static_cast<std::size_t>(mesh.face[e])});
  putHolesAndRegions(volumesOf(mesh), file);
}

}  // namespace af2::geometry
