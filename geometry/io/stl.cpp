// Binary STL: loose triangles in single precision, which is all that the format can hold.
#include <array>
#include <string>

#include "engine/base/error.h"
#include "geometry/io/formats.h"
#include "geometry/mesh/triangles_of.h"

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

std::array<float, 3> rounded(const Point3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// A small model far from the origin would lose triangles without a word.
void refuseWhatCollapses(const ModelMesh& mesh) {
  std::size_t count = 0;
  for (const Element& element : mesh.elements) {
    const auto c = element.vertices();
    for (std::size_t i = 0; i < c.size(); ++i)
      if (rounded(mesh.vertices[c[i].value]) == rounded(mesh.vertices[c[(i + 1) % c.size()].value]))
        ++count;
  }
  if (count > 0)
    throw InputError("cannot write an STL file: in its single precision " + std::to_string(count) +
                     " sides of elements would have no length; write another format, or move the "
                     "model to the origin");
}

}  // namespace

void writeStl(const ModelMesh& mesh, const Extras&, OutputFile& file) {
  refuseWhatCollapses(mesh);
  std::uint32_t triangles = 0;
  for (const Element& element : mesh.elements) triangles += element.isQuad() ? 2 : 1;
  file.bytes(kHeader, sizeof kHeader);
  file.binary(triangles);
  for (const Element& element : mesh.elements)
    for (const auto& [a, b, c] : trianglesOf(mesh, element))
      putTriangle(file, mesh.vertices[a.value], mesh.vertices[b.value], mesh.vertices[c.value]);
}

}  // namespace af2::geometry
