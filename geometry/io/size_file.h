// Reads wanted sizes from a JSON file (docs/formats.md explains each field).
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "geometry/sizes/chord.h"
#include "geometry/sizes/size_sources.h"

namespace af2::geometry {

struct SizeFile {
  SizeSources sources;
  /// Sizes by name, where `*` matches any text and `?` any character, in the order of the file; the
  /// last match counts.
  std::vector<std::pair<std::string, double>> parts;
  /// Bounds on the distance from the model, by name in the same way.
  std::vector<std::pair<std::string, ChordBound>> chords;
};

/// Throws InputError, naming the file and the place in it, for anything unknown or invalid.
AF2_EXPORT SizeFile readSizeFile(const std::filesystem::path& path);

}  // namespace af2::geometry
