// Wanted sizes from a file: JSON (docs/formats.md tells each field).
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "geometry/sizes/size_sources.h"

namespace af2::geometry {

struct SizeFile {
  SizeSources sources;
  /// Sizes by name, where `*` stands for any text and `?` for any character; in the order of the
  /// file, the last one that fits counts.
  std::vector<std::pair<std::string, double>> parts;
};

/// Throws InputError, naming the file and the place in it, for anything that it does not
/// understand.
AF2_EXPORT SizeFile readSizeFile(const std::filesystem::path& path);

}  // namespace af2::geometry
