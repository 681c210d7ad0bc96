// Reads points from a JSON file (docs/formats.md).
#pragma once

#include <filesystem>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2::geometry {

/// Throws InputError, naming the file and the place in it, for anything unknown or invalid.
AF2_EXPORT std::vector<Point3> readPoints(const std::filesystem::path& path);

}  // namespace af2::geometry
