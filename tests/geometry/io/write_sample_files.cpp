// Writes the sample cube in every format: write_sample_files DIRECTORY
#include <filesystem>
#include <string>

#include "geometry/io/mesh_files.h"
#include "small_meshes.h"

int main(int, char** arguments) {
  const std::filesystem::path directory = arguments[1];
  for (const af2::geometry::MeshFormat& format : af2::geometry::meshFormats()) {
    af2::geometry::writeMesh(af2::geometry::cubeMesh(),
                             directory / ("cube" + std::string(format.extension)));
  }
}
