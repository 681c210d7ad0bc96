// TetGen's .smesh: a closed surface, from which `tetgen -pq` makes tetrahedra. Each model face is a
// boundary marker.
#include "geometry/io/formats.h"
#include "geometry/io/triangles_of.h"

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

}  // namespace

void writeSmesh(const ModelMesh& mesh, Lines, OutputFile& file) {
  putRow(file, cornerVertices(mesh).size(), {3, 0, 0});
  for (std::size_t v = 0; v < cornerVertices(mesh).size(); ++v) {
    file.number(v + 1);
    for (const double x : {mesh.vertices[v].x, mesh.vertices[v].y, mesh.vertices[v].z}) {
      file.text(" ");
      file.number(x);
    }
    file.text("\n");
  }
  std::size_t triangles = 0;
  for (const Element& element : mesh.elements) triangles += element.isQuad() ? 2 : 1;
  putRow(file, triangles, {1});
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const auto& [a, b, c] : trianglesOf(mesh, mesh.elements[e]))
      putRow(file, 3,
             {a.value + 1u, b.value + 1u, c.value + 1u, static_cast<std::size_t>(mesh.face[e])});
  file.text("0\n0\n");  // no holes, no regions
}

}  // namespace af2::geometry
