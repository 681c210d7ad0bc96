// Writes the sample cube in every format: write_sample_files DIRECTORY
#include <filesystem>
#include <string>

#include "geometry/io/mesh_files.h"
#include "geometry/mesh/second_order.h"
#include "tests/support/small_meshes.h"

namespace {

/// With straight sides.
af2::geometry::ModelMesh cubeOfSecondOrder() {
  af2::geometry::ModelMesh mesh = af2::geometry::cubeMesh();
  std::vector<af2::geometry::SideMiddles> middles;
  for (const af2::Element& element : mesh.elements) {
    const auto corners = element.vertices();
    af2::geometry::SideMiddles& own = middles.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i)
      own[i] = 0.5 * (mesh.vertices[corners[i].value] +
                      mesh.vertices[corners[(i + 1) % corners.size()].value]);
  }
  for (af2::geometry::EdgeSegment& segment : mesh.segments)
    segment.middle = 0.5 * (mesh.vertices[segment.from.value] + mesh.vertices[segment.to.value]);
  makeSecondOrder(mesh, middles);
  return mesh;
}

/// Edges 1 and 3 are boundary 5, edge 2 has a name and a number that files cannot have.
af2::geometry::ModelMesh withBoundaries(af2::geometry::ModelMesh mesh) {
  mesh.boundaries = {{-2, "inlet", {2}}, {5, "", {1, 3}}};
  return mesh;
}

}  // namespace

int main(int, char** arguments) {
  using namespace af2::geometry;
  const std::filesystem::path directory = arguments[1];
  for (const MeshFormat& format : meshFormats()) {
    if (format.isOnlyPlanar || !isAvailable(format)) continue;  // a cube is not planar
    const std::string extension(format.extension);
    writeMesh(cubeMesh(), directory / ("cube" + extension));
    writeMesh(withBoundaries(cubeMesh()), directory / ("marked" + extension));
    writeMesh(withBoundaries(cubeMesh()), directory / ("lines" + extension), LinesAlong::AllEdges);
    if (format.holdsGroups)
      writeMesh(cubeMesh(), directory / ("grouped" + extension),
                FileOptions{LinesAlong::Boundaries, {Grouping::Faces, Grouping::Parts}});
    if (format.isCompressible)
      writeMesh(cubeMesh(), directory / ("packed" + extension),
                FileOptions{LinesAlong::Boundaries, {}, true});
    if (!format.holdsSecondOrder) continue;
    writeMesh(cubeOfSecondOrder(), directory / ("cube2" + extension));
    writeMesh(cubeOfSecondOrder(), directory / ("lines2" + extension), LinesAlong::AllEdges);
  }
}
