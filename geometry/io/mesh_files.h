// Mesh files: which formats there are, and writing a mesh in the one that a file's name asks for.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "engine/base/export.h"
#include "geometry/io/line_elements.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

class OutputFile;

struct AF2_EXPORT MeshFormat {
  std::string_view extension;  ///< with the dot, lower case
  std::string_view name;
  void (*write)(const ModelMesh&, std::span<const LineElement>, OutputFile&);
  bool holdsSecondOrder = false;  ///< if not, the middles of sides are left out
  bool holdsLines = false;        ///< line elements; if not, they are left out
};

/// In the order in which help texts name them.
AF2_EXPORT std::span<const MeshFormat> meshFormats();

/// The format that the extension of `file` stands for; upper and lower case are the same.
/// Throws InputError, naming the known extensions, if there is none.
AF2_EXPORT const MeshFormat& meshFormatOf(const std::filesystem::path& file);

/// Writes `mesh` to `file`, whole or not at all. Throws InputError as meshFormatOf and OutputFile
/// do.
AF2_EXPORT void writeMesh(const ModelMesh& mesh, const std::filesystem::path& file,
                          LinesAlong along = LinesAlong::Boundaries);

}  // namespace af2::geometry
