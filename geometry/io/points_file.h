// Reads vertices and curves inside faces from a JSON file (docs/formats.md).
#pragma once

#include <filesystem>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2::geometry {

/// What the mesh of a model keeps inside faces.
struct InsideFaces {
  std::vector<Point3> points;               ///< become vertices
  std::vector<std::vector<Point3>> curves;  ///< polylines; their points become vertices, too

  bool isEmpty() const { return points.empty() && curves.empty(); }
};

/// Throws InputError, naming the file and the place in it, for anything unknown or invalid.
AF2_EXPORT InsideFaces readInsideFaces(const std::filesystem::path& path);

}  // namespace af2::geometry
