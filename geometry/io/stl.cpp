// Binary STL: loose triangles in single precision, which is all that the format can hold.
#include "geometry/io/formats.h"
#include "geometry/io/triangles_of.h"

namespace af2::geometry {
namespace {

constexpr char kHeader[80] = "surface mesh by AF2";  // must not begin with "solid"

void putVector(OutputFile& file, const Point3& p) {
  file.binary(static_cast<float>(p.x));
  file.binary(static_cast<float>(p.y));
  file.binary(static_cast<float>(p.z));
}

void putTriangle(OutputFile& file, const Point3& a, const Point3& b, const Point3& c) {
  putVector(file, unit(cross(b - a, c - a)));
  putVector(file, a);
  putVector(file, b);
  putVector(file, c);
  file.binary(std::uint16_t{0});
}

}  // namespace

void writeStl(const ModelMesh& mesh, OutputFile& file) {
  std::uint32_t triangles = 0;
  for (const Element& element : mesh.elements) triangles += element.isQuad() ? 2 : 1;
  file.bytes(kHeader, sizeof kHeader);
  file.binary(triangles);
  for (const Element& element : mesh.elements)
    for (const auto& [a, b, c] : trianglesOf(mesh, element))
      putTriangle(file, mesh.vertices[a.value], mesh.vertices[b.value], mesh.vertices[c.value]);
}

}  // namespace af2::geometry
