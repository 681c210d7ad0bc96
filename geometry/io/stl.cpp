// Binary STL: loose triangles in single precision, which is all that the format can hold.
#include "geometry/io/formats.h"

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

/// Split along the shorter diagonal, the first one if both are equally long.
void putQuad(OutputFile& file, const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const bool alongAc = distance(a, c) <= distance(b, d);
  putTriangle(file, a, b, alongAc ? c : d);
  putTriangle(file, alongAc ? a : b, c, d);
}

}  // namespace

void writeStl(const ModelMesh& mesh, OutputFile& file) {
  std::uint32_t triangles = 0;
  for (const Element& element : mesh.elements) triangles += element.isQuad() ? 2 : 1;
  file.bytes(kHeader, sizeof kHeader);
  file.binary(triangles);
  for (const Element& element : mesh.elements) {
    const auto corner = [&](int i) { return mesh.vertices[element.corners[std::size_t(i)].value]; };
    if (element.isQuad())
      putQuad(file, corner(0), corner(1), corner(2), corner(3));
    else
      putTriangle(file, corner(0), corner(1), corner(2));
  }
}

}  // namespace af2::geometry
