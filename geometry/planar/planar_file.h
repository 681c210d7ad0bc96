// Reads planar domains from files, in the format that the extension selects.
#pragma once

#include <filesystem>
#include <span>

#include "engine/base/export.h"
#include "geometry/base/file_extension.h"
#include "geometry/planar/poly_file.h"

namespace af2::geometry {

struct AF2_EXPORT PlanarFormat : FileFormat {
  PlanarDomain (*read)(const std::filesystem::path&);
};

/// In the order in which messages list them.
AF2_EXPORT std::span<const PlanarFormat> planarFormats();

/// Throws InputError, with file and line, if the file cannot be read, or if its extension is
/// unknown.
AF2_EXPORT PlanarDomain readPlanar(const std::filesystem::path& path);

}  // namespace af2::geometry
