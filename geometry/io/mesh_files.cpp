#include "geometry/io/mesh_files.h"

#include <array>
#include <string>

#include "engine/base/error.h"
#include "geometry/base/file_extension.h"
#include "geometry/io/formats.h"
#include "geometry/io/output_file.h"

namespace af2::geometry {
namespace {

constexpr std::array kFormats{
    MeshFormat{".vtu", "VTK XML unstructured grid", &writeVtu, true, true},
    MeshFormat{".vtk", "legacy VTK", &writeVtk, false, true},
    MeshFormat{".msh", "Gmsh 4.1", &writeMsh, true, true},
    MeshFormat{".stl", "STL", &writeStl},
    MeshFormat{".obj", "Wavefront OBJ", &writeObj},
    MeshFormat{".ply", "PLY", &writePly},
    MeshFormat{".smesh", "TetGen", &writeSmesh},
};

std::string knownExtensions() {
  std::string list;
  for (const MeshFormat& format : kFormats) list += " " + std::string(format.extension);
  return list;
}

}  // namespace

std::span<const MeshFormat> meshFormats() { return kFormats; }

const MeshFormat& meshFormatOf(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  for (const MeshFormat& format : kFormats) {
    if (format.extension == extension) return format;
  }
  throw InputError("cannot write '" + file.string() + "': its extension names no mesh format; use" +
                   knownExtensions());
}

void writeMesh(const ModelMesh& mesh, const std::filesystem::path& file, LinesAlong along) {
  const MeshFormat& format = meshFormatOf(file);
  OutputFile output(file);
  format.write(mesh, format.holdsLines ? lineElements(mesh, along) : std::vector<LineElement>(),
               output);
  output.commit();
}

}  // namespace af2::geometry
