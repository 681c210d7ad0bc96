// Reads mesh files back: those that AF2 writes, and what other programs write in these formats.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "engine/base/export.h"
#include "geometry/base/file_extension.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

class MeshBuilder;

struct AF2_EXPORT MeshFileFormat : FileFormat {
  /// Adds what the content of a file says to the mesh. Throws InputError with file and place.
  void (*read)(const std::string& content, MeshBuilder& mesh) = nullptr;
};

/// In the order in which messages list them.
AF2_EXPORT std::span<const MeshFileFormat> meshFileFormats();

struct MeshFile {
  /// Vertices, first-order elements with their faces, segments for the lines of the file, wanted
  /// sizes if the file has them, and notes on what was left out. Origins are not known.
  ModelMesh mesh;
  bool hasFaces = false;  ///< whether the file says to which face an element belongs; else all to 1
};

/// Reads a mesh, in the format that the extension selects. Of elements of second order, only the
/// corners are read; elements that are neither triangles nor quadrilaterals are left out with a
/// note. In STL files, vertices at the same position are merged.
///
/// Throws InputError, with file, place and way out, if the file cannot be read or has no elements.
AF2_EXPORT MeshFile readMesh(const std::filesystem::path& path);

}  // namespace af2::geometry
