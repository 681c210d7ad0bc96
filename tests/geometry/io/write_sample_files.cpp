// Writes the sample cube in every format: write_sample_files DIRECTORY
#include <filesystem>
#include <string>

#include "geometry/io/mesh_files.h"
#include "geometry/second_order.h"
#include "small_meshes.h"

namespace {

/// With straight sides.
af2::geometry::ModelMesh cubeOfSecondOrder() {
  af2::geometry::ModelMesh mesh = af2::geometry::cubeMesh();
  mesh.segments.clear();
  std::vector<af2::geometry::SideMiddles> middles;
  for (const af2::Element& element : mesh.elements) {
    const auto corners = element.vertices();
    af2::geometry::SideMiddles& own = middles.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i)
      own[i] = 0.5 * (mesh.vertices[corners[i].value] +
                      mesh.vertices[corners[(i + 1) % corners.size()].value]);
  }
  makeSecondOrder(mesh, middles);
  return mesh;
}

}  // namespace

int main(int, char** arguments) {
  const std::filesystem::path directory = arguments[1];
  for (const af2::geometry::MeshFormat& format : af2::geometry::meshFormats()) {
    af2::geometry::writeMesh(af2::geometry::cubeMesh(),
                             directory / ("cube" + std::string(format.extension)));
    if (format.holdsSecondOrder)
      af2::geometry::writeMesh(cubeOfSecondOrder(),
                               directory / ("cube2" + std::string(format.extension)));
  }
}
