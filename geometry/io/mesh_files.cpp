#include "geometry/io/mesh_files.h"

#include <string>

#include "engine/base/error.h"
#include "geometry/base/file_extension.h"
#include "geometry/io/formats.h"
#include "geometry/io/output_file.h"

namespace af2::geometry {
namespace {

std::string knownExtensions() {
  std::string list;
  for (const MeshFormat& format : kMeshFormats) list += " " + std::string(format.extension);
  return list;
}

}  // namespace

std::span<const MeshFormat> meshFormats() { return kMeshFormats; }

const MeshFormat& meshFormatOf(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  for (const MeshFormat& format : kMeshFormats) {
    if (format.extension == extension) return format;
  }
  throw InputError("cannot write '" + file.string() +
                   "': its extension is not that of a mesh format; use" + knownExtensions());
}

void writeMesh(const ModelMesh& mesh, const std::filesystem::path& file, LinesAlong along) {
  const MeshFormat& format = meshFormatOf(file);
  OutputFile output(file);
  format.write(mesh, format.holdsLines ? lineElements(mesh, along) : std::vector<LineElement>(),
               output);
  output.commit();
}

}  // namespace af2::geometry
