// Writes mesh files, in the format that the extension of the file selects.
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
  bool holdsSecondOrder = false;  ///< if false, the middles of sides are left out
  bool holdsLines = false;        ///< line elements; if false, they are left out
  bool holdsScores = false;       ///< ModelMesh::scores; if false, they are left out
  bool isOnlyPlanar = false;      ///< for meshes of planar domains only
};

/// In the order in which help texts name them.
AF2_EXPORT std::span<const MeshFormat> meshFormats();

/// The format for the extension of `file`, in upper or lower case. Throws InputError, naming the
/// known extensions, if there is none.
AF2_EXPORT const MeshFormat& meshFormatOf(const std::filesystem::path& file);

/// Writes `mesh` to `file`, completely or not at all. Throws InputError as meshFormatOf and
/// OutputFile do.
AF2_EXPORT void writeMesh(const ModelMesh& mesh, const std::filesystem::path& file,
                          LinesAlong along = LinesAlong::Boundaries);

}  // namespace af2::geometry
