// Writes mesh files, in the format that the extension of the file selects.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "geometry/io/line_elements.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

class OutputFile;

/// What a face may be grouped by.
enum class Grouping {
  Faces,  ///< the name of the face in the file of the model; it has none otherwise
  Parts,
  Solids,
  Layers,
  Colors,
  Interfaces,  ///< of two parts that share it
};

/// Word and value, in the order in which help texts name them.
AF2_EXPORT std::span<const std::pair<std::string_view, Grouping>> groupings();

/// What files have besides elements, where their format can hold it.
struct FileOptions {
  LinesAlong lines = LinesAlong::Boundaries;
  /// Not empty: each face belongs to one group only, that of the first of these kinds in which it
  /// has one; of several of this kind, that with the fewest faces, then the first of the model. A
  /// face in none is a group of its own. Empty: each face belongs to all its groups and to one of
  /// its own; but in formats that allow one group only, this is {Grouping::Faces}.
  std::vector<Grouping> groups = {};
  bool compress = false;  ///< compress arrays with zlib, in formats that can
};

using Lines = std::span<const LineElement>;

/// The same for the writer of a format.
struct Extras {
  Lines lines;
  std::span<const Grouping> groups;
  bool compress = false;
};

struct AF2_EXPORT MeshFormat {
  std::string_view extension;  ///< with the dot, lower case
  std::string_view name;
  void (*write)(const ModelMesh&, const Extras&, OutputFile&);
  bool holdsSecondOrder = false;  ///< if false, the middles of sides are left out
  bool holdsLines = false;        ///< line elements; if false, they are left out
  bool holdsScores = false;       ///< ModelMesh::scores; if false, they are left out
  bool isOnlyPlanar = false;      ///< for meshes of planar domains only
  bool holdsGroups = false;       ///< FileOptions::groups; if false, they do not matter
  bool isCompressible = false;    ///< FileOptions::compress; if false, it does not matter
  /// The library of AF2 that writes it, which may be missing; empty: none is needed.
  std::string_view writer = {};
  bool holdsSpooled = false;  ///< whether a mesh on disk can be written (ModelMesh::spooled)
};

/// In the order in which help texts name them.
AF2_EXPORT std::span<const MeshFormat> meshFormats();

/// Whether the library that it needs, if any, is there.
AF2_EXPORT bool isAvailable(const MeshFormat& format);

/// The format for the extension of `file`, in upper or lower case. Throws InputError, naming the
/// known extensions, if there is none, or the library that is missing.
AF2_EXPORT const MeshFormat& meshFormatOf(const std::filesystem::path& file);

/// Writes `mesh` to `file`, completely or not at all. Throws InputError as meshFormatOf and
/// OutputFile do.
AF2_EXPORT void writeMesh(const ModelMesh& mesh, const std::filesystem::path& file,
                          const FileOptions& options);
AF2_EXPORT void writeMesh(const ModelMesh& mesh, const std::filesystem::path& file,
                          LinesAlong along = LinesAlong::Boundaries);

}  // namespace af2::geometry
