// STL: loose triangles. Binary in single precision, which is all that it can hold; or, with groups,
// text with a solid for each group.
#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "geometry/formats/msh_groups.h"
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
  forEachElement(mesh, [&](const MeshSlice& slice, std::size_t e) {
    const auto c = slice.elements[e].vertices();
    for (std::size_t i = 0; i < c.size(); ++i)
      if (rounded(slice.position(c[i])) == rounded(slice.position(c[(i + 1) % c.size()]))) ++count;
  });
  if (count > 0)
    throw InputError("cannot write an STL file: in its single precision " + std::to_string(count) +
                     " sides of elements would have no length; write another format, or move the "
                     "model to the origin");
}

void putText(OutputFile& file, const char* word, const Point3& p) {
  file.text(word);
  for (const double x : {p.x, p.y, p.z}) {
    file.text(" ");
    file.number(x);
  }
  file.text("\n");
}

void putTextTriangle(OutputFile& file, const Point3& a, const Point3& b, const Point3& c) {
  putText(file, "facet normal", unit(cross(b - a, c - a)));
  file.text("outer loop\n");
  for (const Point3& corner : {a, b, c}) putText(file, "vertex", corner);
  file.text("endloop\nendfacet\n");
}

/// One solid for each group, in the order of the groups' numbers.
void writeSolids(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  const MshGroups groups(mesh, {{}, extras.groups}, {});
  std::map<std::int32_t, std::vector<FaceElements>> solids;
  for (const FaceElements& some : elementsByFace(mesh))
    solids[groups.ofFace(some.face).front()].push_back(some);
  for (const auto& [group, own] : solids) {
    const std::string name = groups.nameOf(own.front().face);
    file.text("solid " + name + "\n");
    for (const FaceElements& some : own)
      forEachElementOf(mesh, some, [&](const MeshSlice& slice, std::size_t e) {
        for (const auto& [a, b, c] : trianglesOf(slice, slice.elements[e]))
          putTextTriangle(file, slice.position(a), slice.position(b), slice.position(c));
      });
    file.text("endsolid " + name + "\n");
  }
}

}  // namespace

void writeStl(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  if (!extras.groups.empty()) return writeSolids(mesh, extras, file);
  refuseWhatCollapses(mesh);
  const std::size_t triangles = elementCount(mesh) + quadCount(mesh);
  if (triangles > std::numeric_limits<std::uint32_t>::max())
    throw InputError(
        "cannot write an STL file: it counts its triangles with 32 bits, and there are " +
        std::to_string(triangles));
  file.bytes(kHeader, sizeof kHeader);
  file.binary(static_cast<std::uint32_t>(triangles));
  forEachElement(mesh, [&](const MeshSlice& slice, std::size_t i) {
    for (const auto& [a, b, c] : trianglesOf(slice, slice.elements[i]))
      putTriangle(file, slice.position(a), slice.position(b), slice.position(c));
  });
}

}  // namespace af2::geometry
