// Reads divisions of edges from a JSON file (docs/formats.md).
#pragma once

#include <filesystem>

#include "engine/base/export.h"
#include "geometry/edges/edge_points.h"

namespace af2::geometry {

/// Throws InputError, naming the file and the place in it, for anything unknown or invalid.
AF2_EXPORT EdgePoints readEdgePoints(const std::filesystem::path& path);

}  // namespace af2::geometry
