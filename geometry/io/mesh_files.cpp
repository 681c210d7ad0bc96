#include "geometry/io/mesh_files.h"

#include <array>
#include <string>

#include "engine/base/error.h"
#include "geometry/base/file_extension.h"
#include "geometry/base/loaded_parts.h"
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

std::span<const std::pair<std::string_view, Grouping>> groupings() {
  static constexpr std::array<std::pair<std::string_view, Grouping>, 6> kGroupings{
      {{"faces", Grouping::Faces},
       {"parts", Grouping::Parts},
       {"solids", Grouping::Solids},
       {"layers", Grouping::Layers},
       {"colors", Grouping::Colors},
       {"interfaces", Grouping::Interfaces}}};
  return kGroupings;
}

std::span<const MeshFormat> meshFormats() { return kMeshFormats; }

bool isAvailable(const MeshFormat& format) {
  return format.writer.empty() || !placeOfPart(std::string(format.writer)).empty();
}

const MeshFormat& meshFormatOf(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  for (const MeshFormat& format : kMeshFormats) {
    if (format.extension != extension) continue;
    if (isAvailable(format)) return format;
    throw InputError(
        "cannot write '" + file.string() + "': the library '" + std::string(format.writer) +
        "', which writes " + std::string(format.name) +
        " files, does not lie with this program; choose another format, install the package "
        "af2-formats, or build AF2 where the library of the format is (docs/formats.md)");
  }
  throw InputError("cannot write '" + file.string() +
                   "': its extension is not that of a mesh format; use" + knownExtensions());
}

void writeMesh(const ModelMesh& mesh, const std::filesystem::path& file,
               const FileOptions& options) {
  const MeshFormat& format = meshFormatOf(file);
  if (mesh.spooled && !format.holdsSpooled)
    throw InputError("cannot write '" + file.string() + "': " + std::string(format.name) +
                     " files need the whole mesh in memory, and it is on disk");
  OutputFile output(file);
  std::vector<LineElement> lines;
  if (format.holdsLines) lines = lineElements(mesh, options.lines);
  format.write(mesh, {lines, options.groups, options.compress}, output);
  output.commit();
}

void writeMesh(const ModelMesh& mesh, const std::filesystem::path& file, LinesAlong along) {
  writeMesh(mesh, file, FileOptions{along, {}, false});
}

}  // namespace af2::geometry
